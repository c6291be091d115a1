#include "programs/kerf/page/file_names.hpp"

#include <filesystem>
#include <string>
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

void leave_out(std::string& text, const std::string& part) {
  for (std::size_t at = text.find(part); !part.empty() && at != std::string::npos;
       at = text.find(part, at)) {
    text.erase(at, part.size());
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
