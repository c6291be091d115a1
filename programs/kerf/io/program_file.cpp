#include "programs/kerf/io/program_file.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <optional>
#include <utility>

#include "programs/kerf/io/interrupt.hpp"

namespace kerf::program {

namespace {

tl::unexpected<std::string> fault(const std::string& name, int error_number) {
  return tl::unexpected(name + ": " + error_text(error_number));
}

// A file without a name: it goes when the process does, whatever ends it.
Descriptor temporary_file() {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::tmpfile(), &std::fclose);
  return file ? Descriptor(::dup(::fileno(file.get()))) : Descriptor();
}

// A pipe, a socket or a terminal: read once, and more may be to come.
bool is_stream(int descriptor) {
  struct stat about {};
  return ::fstat(descriptor, &about) == 0 &&
         (S_ISFIFO(about.st_mode) || S_ISSOCK(about.st_mode) || ::isatty(descriptor) == 1);
}

// Why standard input cannot be read. Nothing: it can.
std::optional<std::string> input_fault() {
  struct stat about {};
  if (::fstat(STDIN_FILENO, &about) != 0) {
    return error_text(errno);
  }
  if (S_ISDIR(about.st_mode)) {
    return error_text(EISDIR);
  }
  if (!S_ISREG(about.st_mode) && !is_stream(STDIN_FILENO)) {
    return "is a device, neither a file nor a pipe";
  }
  return std::nullopt;
}

// What standard input still gives, in a temporary file: it may be a file that somebody has read a
// part of. Error: why not.
tl::expected<Descriptor, std::string> copy_of_input(std::uint64_t max_bytes) {
  if (auto fault = input_fault()) {
    return tl::unexpected(std::move(*fault));
  }
  Descriptor to = temporary_file();
  if (!to.is_open()) {
    return tl::unexpected("no temporary file for it: " + error_text(errno));
  }
  std::vector<char> buffer(ProgramFile::kPieceBytes);
  std::uint64_t copied = 0;
  while (!stop_requested()) {
    const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count == 0) {
      break;
    }
    if (count < 0) {
      if (errno == EINTR) {
        continue;
      }
      return tl::unexpected(error_text(errno));
    }
    const auto bytes = static_cast<std::size_t>(count);
    copied += bytes;
    if (copied > max_bytes) {
      return tl::unexpected("more than " + std::to_string(max_bytes) +
                            " bytes: write them into a file and give its name");
    }
    if (const int error = write_all(to.number(), {buffer.data(), bytes})) {
      return tl::unexpected("its temporary copy: " + error_text(error));
    }
  }
  return to;
}

}  // namespace

ProgramFile::ProgramFile(std::string name, Descriptor descriptor)
    : name_(std::move(name)), descriptor_(std::move(descriptor)), buffer_(kPieceBytes) {}

Descriptor ProgramFile::open_live(const std::string& path) {
  const bool is_input = path == "-";
  struct stat about {};
  const int failed = is_input ? ::fstat(STDIN_FILENO, &about) : ::stat(path.c_str(), &about);
  if (failed != 0 || S_ISREG(about.st_mode) || S_ISDIR(about.st_mode)) {
    return {};
  }
  // Once: whoever has opened the other end of a FIFO would find it closed.
  Descriptor source(is_input ? ::dup(STDIN_FILENO)
                             : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  return source.is_open() && is_stream(source.number()) ? std::move(source) : Descriptor();
}

tl::expected<ProgramFile, std::string> ProgramFile::open(const std::string& path,
                                                         std::uint64_t max_copied_bytes) {
  const std::string name = path == "-" ? "<stdin>" : path;
  auto source = path == "-" ? copy_of_input(max_copied_bytes) : open_regular(path);
  if (!source) {
    return tl::unexpected(name + ": " + source.error());
  }
  ProgramFile file(name, *std::move(source));
  if (const auto taken = file.take_stock(); !taken) {
    return tl::unexpected(taken.error());
  }
  return file;
}

tl::expected<void, std::string> ProgramFile::take_stock() {
  struct stat about {};
  if (::fstat(descriptor_.number(), &about) != 0) {
    return fault(name_, errno);
  }
  size_bytes_ = static_cast<std::uint64_t>(about.st_size);
  changed_ = about.st_mtim;
  return {};
}

tl::expected<std::string_view, std::string> ProgramFile::read() {
  struct stat about {};
  if (::fstat(descriptor_.number(), &about) != 0) {
    return fault(name_, errno);
  }
  if (static_cast<std::uint64_t>(about.st_size) != size_bytes_ ||
      about.st_mtim.tv_sec != changed_.tv_sec || about.st_mtim.tv_nsec != changed_.tv_nsec) {
    return tl::unexpected(name_ + ": changed while it was read");
  }
  ssize_t count = 0;
  do {
    count =
        ::pread(descriptor_.number(), buffer_.data(), buffer_.size(), static_cast<off_t>(offset_));
  } while (count < 0 && errno == EINTR);
  if (count < 0) {
    return fault(name_, errno);
  }
  offset_ += static_cast<std::uint64_t>(count);
  return std::string_view(buffer_.data(), static_cast<std::size_t>(count));
}

}  // namespace kerf::program
