#include "programs/kerf/io/output_file.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>

namespace kerf::program {

namespace {

// /dev/stdout where that is a file: it would lose its name to ours.
bool is_standard_stream(const struct stat& file) {
  const auto is = [&file](int descriptor) {
    struct stat about {};
    return ::fstat(descriptor, &about) == 0 && about.st_dev == file.st_dev &&
           about.st_ino == file.st_ino;
  };
  return is(STDOUT_FILENO) || is(STDERR_FILENO);
}

// Where a link leads, so that the link stays one. Empty: what is there is no regular file, or its
// place cannot be found.
std::string regular_target(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) == 0) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::canonical(path, error);
    return S_ISREG(about.st_mode) && !is_standard_stream(about) && !error ? target.string() : "";
  }
  return ::lstat(path.c_str(), &about) == 0 ? "" : path;
}

}  // namespace

std::string incomplete_name(const std::string& path) {
  return path + ".incomplete";
}

tl::expected<OutputFile, std::string> OutputFile::create(const std::string& path) {
  if (path == "-") {
    OutputFile output("<stdout>", Descriptor(::dup(STDOUT_FILENO)));
    if (!output.descriptor_.is_open()) {
      return tl::unexpected(output.name_ + ": " + error_text(errno));
    }
    return output;
  }
  const std::string target = regular_target(path);
  const std::string place = target.empty() ? path : incomplete_name(target);
  const bool follows_incomplete = !target.empty() && ::access(place.c_str(), F_OK) == 0;
  OutputFile file(
      path, Descriptor(::open(place.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)));
  if (!file.descriptor_.is_open()) {
    return tl::unexpected(path + ": " + error_text(errno));
  }
  file.final_path_ = target;
  file.follows_incomplete_ = follows_incomplete;
  return file;
}

OutputFile::~OutputFile() {
  if (descriptor_.is_open() && !final_path_.empty() && !written_) {
    ::unlink(incomplete_name(final_path_).c_str());
  }
}

int OutputFile::write(std::string_view bytes) noexcept {
  // An older file goes once there is something to stand in its place.
  if (!written_ && !final_path_.empty() && ::unlink(final_path_.c_str()) != 0 && errno != ENOENT) {
    return errno;
  }
  written_ = written_ || !bytes.empty();
  return write_all(descriptor_.number(), bytes);
}

int OutputFile::write_again(std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t count = ::pwrite(descriptor_.number(), bytes.data(), bytes.size(), 0);
    if (count == static_cast<ssize_t>(bytes.size())) {
      return 0;
    }
    if (count >= 0) {
      return ENOSPC;  // some of what is there already
    }
    if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

int OutputFile::finish(bool whole) noexcept {
  if (const int error = descriptor_.close(); error != 0 || !whole || final_path_.empty()) {
    return error;
  }
  if (std::rename(incomplete_name(final_path_).c_str(), final_path_.c_str()) != 0) {
    return errno;
  }
  final_path_.clear();
  return 0;
}

std::string OutputFile::remains() const {
  return final_path_.empty() ? "" : "; what was written is in " + incomplete_name(final_path_);
}

}  // namespace kerf::program
