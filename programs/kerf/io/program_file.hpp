// The text of a part program, readable twice: once to check it, once to run it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <vector>

#include <tl/expected.hpp>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// The file stays open, so that deleting or replacing it does not matter to a run. One that is
// written to between the check and the end of the run is an error: another program would run than
// was checked. Memory is one piece. Standard input cannot be read twice and is first copied to an
// unnamed temporary file; under a path there must be a regular file.
class ProgramFile {
 public:
  static constexpr std::size_t kPieceBytes = std::size_t{64} * 1024;

  static constexpr std::uint64_t kMaxCopiedBytes = std::uint64_t{4} << 30U;

  // Opens a source that can be read only once and may still grow: a pipe, a socket, a terminal.
  // Does not wait for its text. Closed: `path` is none of these.
  [[nodiscard]] static Descriptor open_live(const std::string& path);

  // path "-" is standard input, of which no more is copied. Error: what the system says, with the
  // path.
  static tl::expected<ProgramFile, std::string> open(
      const std::string& path, std::uint64_t max_copied_bytes = kMaxCopiedBytes);

  // The name for diagnostics: the path, or <stdin>.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] std::uint64_t size_bytes() const noexcept { return size_bytes_; }
  [[nodiscard]] std::uint64_t bytes_read() const noexcept { return offset_; }

  // The next piece, valid until the next call; empty at the end.
  tl::expected<std::string_view, std::string> read();
  void rewind() noexcept { offset_ = 0; }

 private:
  ProgramFile(std::string name, Descriptor descriptor);
  tl::expected<void, std::string> take_stock();

  std::string name_;
  Descriptor descriptor_;
  std::vector<char> buffer_;
  std::uint64_t size_bytes_ = 0;
  std::uint64_t offset_ = 0;
  timespec changed_{};
};

}  // namespace kerf::program
