#include "programs/kerf/page/file_names.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace kerf::program {

namespace {

std::string name_of(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

// Those whose names are not all of them.
std::vector<std::string> paths_in(const FileReport& report) {
  std::vector<std::string> paths;
  const auto add = [&paths](const std::string& path) {
    if (path.find('/') != std::string::npos) {
      paths.push_back(path);
    }
  };
  add(report.file);
  add(report.machine);
  for (const diagnostics::Diagnostic& diagnostic : report.diagnostics) {
    add(diagnostic.file);
  }
  return paths;
}

// With what separates it from the name of a file in it; empty: the file has none.
std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() || folder == "/" ? "" : folder + "/";
}

struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// Whether a folder that is found in a text is the begin of a path there: one may be called "mm",
// and a feed is in mm/min.
bool begins_path(std::string_view text, const Span& folder) {
  constexpr std::string_view kBefore = " '\"([:,";
  const std::string_view rest = text.substr(folder.end);
  const std::string_view name = rest.substr(0, rest.find_first_of(" ,;:'\")"));
  const bool is_unit = name == "min" || name == "s" || name == "s2" || name == "s3";
  const bool is_begin =
      folder.begin == 0 || kBefore.find(text[folder.begin - 1]) != std::string_view::npos;
  return is_begin && !is_unit;
}

void leave_out(std::string& text, const std::string& folder) {
  for (std::size_t at = text.find(folder); !folder.empty() && at != std::string::npos;
       at = text.find(folder, at)) {
    if (begins_path(text, {.begin = at, .end = at + folder.size()})) {
      text.erase(at, folder.size());
    } else {
      at += folder.size();
    }
  }
}

void name_files(std::string& text, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const std::string name = name_of(path);
    for (std::size_t at = text.find(path); at != std::string::npos;
         at = text.find(path, at + name.size())) {
      text.replace(at, path.size(), name);
    }
  }
}

}  // namespace

FileReport with_file_names(FileReport report) {
  const std::vector<std::string> paths = paths_in(report);
  if (paths.empty()) {
    return report;
  }
  const std::string folder = folder_of(report.file);  // subprograms lie there
  report.file = name_of(report.file);
  report.machine = name_of(report.machine);
  for (diagnostics::Diagnostic& diagnostic : report.diagnostics) {
    diagnostic.file = name_of(diagnostic.file);
    name_files(diagnostic.message, paths);
    leave_out(diagnostic.message, folder);
  }
  for (std::vector<std::string>* const messages : {&report.failures, &report.warnings}) {
    for (std::string& message : *messages) {
      name_files(message, paths);
    }
  }
  return report;
}

}  // namespace kerf::program
