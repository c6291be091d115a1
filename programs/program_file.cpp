#include "programs/program_file.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <utility>

#include "programs/interrupt.hpp"

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

// What `from` still gives, in a temporary file.
tl::expected<Descriptor, std::string> spool(const std::string& name, int from) {
  Descriptor to = temporary_file();
  if (!to.is_open()) {
    return tl::unexpected("no temporary file for " + name + ": " + error_text(errno));
  }
  std::vector<char> buffer(ProgramFile::kPieceBytes);
  while (!stop_requested()) {
    const ssize_t count = ::read(from, buffer.data(), buffer.size());
    if (count == 0) {
      break;
    }
    if (count < 0) {
      if (errno == EINTR) {
        continue;
      }
      return fault(name, errno);
    }
    if (const int error =
            write_all(to.number(), {buffer.data(), static_cast<std::size_t>(count)})) {
      return tl::unexpected("the temporary copy of " + name + ": " + error_text(error));
    }
  }
  return to;
}

}  // namespace

ProgramFile::ProgramFile(std::string name, Descriptor descriptor)
    : name_(std::move(name)), descriptor_(std::move(descriptor)), buffer_(kPieceBytes) {}

bool ProgramFile::is_live(const std::string& path) noexcept {
  struct stat about {};
  const int failed = path == "-" ? ::fstat(STDIN_FILENO, &about) : ::stat(path.c_str(), &about);
  return failed == 0 && !S_ISREG(about.st_mode) && !S_ISDIR(about.st_mode);
}

tl::expected<ProgramFile, std::string> ProgramFile::open(const std::string& path) {
  const bool is_input = path == "-";
  const std::string name = is_input ? "<stdin>" : path;
  Descriptor source(is_input ? ::dup(STDIN_FILENO) : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!source.is_open()) {
    return fault(name, errno);
  }
  struct stat about {};
  if (::fstat(source.number(), &about) != 0) {
    return fault(name, errno);
  }
  if (S_ISDIR(about.st_mode)) {
    return fault(name, EISDIR);
  }
  // Standard input may be a file that somebody has read a part of: only the copy begins where it
  // does.
  if (is_input || !S_ISREG(about.st_mode)) {
    auto copy = spool(name, source.number());
    if (!copy) {
      return tl::unexpected(copy.error());
    }
    source = std::move(*copy);
  }
  ProgramFile file(name, std::move(source));
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
