#include "programs/kerf/io/subprogram_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace kerf::program {

namespace {

using parser::SubprogramText;

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20U;

std::string in_capitals(std::string_view name) {
  std::string text(name);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c & ~0x20) : c; });
  return text;
}

// How a Fanuc program may be called in a folder but for its extension: O1000, o1000; POCKET,
// pocket.
std::array<std::string, 2> fanuc_names(std::string_view name) {
  if (name.find_first_not_of("0123456789") == std::string_view::npos) {
    const std::string four = std::string(name.size() < 4 ? 4 - name.size() : 0, '0');
    return {("O" + four).append(name), ("o" + four).append(name)};
  }
  return {in_capitals(name), std::string(name)};
}

std::vector<std::string> file_names(std::string_view name, parser::Dialect dialect) {
  std::vector<std::string> names;
  if (dialect == parser::Dialect::fanuc) {
    for (const std::string& stem : fanuc_names(name)) {
      for (const char* const extension : {".nc", ".NC", ".ngc", ""}) {
        names.push_back(stem + extension);
      }
    }
  }
  names.push_back(std::string(name) + ".ngc");
  return names;
}

// Whether the file lies where its name says, wherever symbolic links lead.
struct FileIn {
  const std::filesystem::path& folder;
  const std::filesystem::path& path;
};
bool lies_there(const FileIn& file) {
  std::error_code error;
  const auto here = std::filesystem::canonical(file.folder.empty() ? "." : file.folder, error);
  const auto there = std::filesystem::canonical(file.path, error);
  return !error && there.parent_path() == here;
}

std::optional<SubprogramText> read(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path path = folder / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) ||
      std::filesystem::file_size(path, error) > kMaxBytes || error) {
    return std::nullopt;
  }
  if (!lies_there({.folder = folder, .path = path})) {
    return SubprogramText{.file = path.string(),
                          .text = {},
                          .refused = "it is a symbolic link out of the program's folder"};
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  return SubprogramText{.file = path.string(), .text = {std::istreambuf_iterator<char>(file), {}}};
}

class Folder {
 public:
  Folder(std::filesystem::path path, parser::Dialect dialect)
      : path_(std::move(path)), dialect_(dialect) {}

  std::optional<SubprogramText> find(std::string_view name) {
    const auto [known, fresh] = texts_.try_emplace(std::string(name));
    // A name is one file of this folder, never a way to another.
    if (fresh && name.find('/') == std::string_view::npos) {
      for (const std::string& file : file_names(name, dialect_)) {
        if (known->second = read(path_, file); known->second) {
          break;
        }
      }
    }
    return known->second;
  }

 private:
  std::filesystem::path path_;
  parser::Dialect dialect_;
  std::map<std::string, std::optional<SubprogramText>> texts_;
};

}  // namespace

parser::SubprogramSource subprograms_beside(const std::string& program, parser::Dialect dialect) {
  const auto folder =
      std::make_shared<Folder>(std::filesystem::path(program).parent_path(), dialect);
  return [folder](std::string_view name) { return folder->find(name); };
}

bool may_be_subprogram(const FileOf& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path path(file.path);
  const fs::path folder = fs::path(file.program).parent_path();
  const std::string stem = path.stem().string();
  const std::string extension = path.extension().string();
  const bool is_number = stem.size() > 1 && (stem[0] == 'O' || stem[0] == 'o') &&
                         stem.find_first_not_of("0123456789", 1) == std::string::npos;
  const bool is_named_so = extension == ".ngc" || extension == ".nc" || extension == ".NC" ||
                           (extension.empty() && (is_number || file.is_fanuc));
  return is_named_so && fs::is_regular_file(path, error) &&
         lies_there({.folder = folder, .path = path});
}

}  // namespace kerf::program
