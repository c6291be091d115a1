// The journal of a run: how far it has come, where a crash cannot take it away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <kerf/controller.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/exit_status.hpp"
#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// What a run is one of. What is read, and how, has to be the same where another goes on.
struct JournalledRun {
  std::string file;
  std::uint64_t program = 0;        // checksum of its text, with what says how it is read
  std::uint64_t machine = 0;        // of the machine file, the tool table and --g54
  std::uint64_t blocks_before = 0;  // StartInProgram

  friend bool operator==(const JournalledRun&, const JournalledRun&) = default;
};

struct JournalledPlace {
  std::uint64_t block = 0;  // TickDetail::block
  std::uint32_t line = 0;
  double run_s = 0.0;
  Position position_mm{};
  std::string state;

  friend bool operator==(const JournalledPlace&, const JournalledPlace&) = default;
};

// A journal as it is read.
struct Journal {
  JournalledRun run{};                     // the last one in it
  std::optional<JournalledPlace> place{};  // its last one
  // The last one on the program's path: held, the tool may have been moved by hand.
  std::optional<JournalledPlace> on_path{};
  std::string change{};              // Operator::first_change(); empty: there was none
  std::optional<int> exit_status{};  // of its end; nothing: it was not brought to one
  std::size_t valid_bytes = 0;       // what is after them is torn

  // The block at which the tool was last.
  [[nodiscard]] std::uint64_t block() const noexcept {
    return place ? place->block : run.blocks_before + 1;
  }
};

// Records are lines, each behind its checksum. They count up to the first that is not whole. Error:
// no run is in it.
tl::expected<Journal, std::string> read_journal(std::string_view bytes);
// The same of a file; also: it cannot be read.
tl::expected<Journal, std::string> read_journal_file(const std::string& path);

// Each record is on the disk once its call is over. After one that could not be written there are
// no more. Not for the tick side.
class JournalWriter {
 public:
  // The file is made anew, or goes on after its valid bytes. Error: what the system says.
  static tl::expected<JournalWriter, std::string> open(const std::string& path,
                                                       const JournalledRun& run,
                                                       std::size_t valid_bytes);

  // 0, or the errno of the first record that could not be written.
  int place(const JournalledPlace& place);
  int change(std::string_view what);
  int end(ExitStatus status);

 private:
  explicit JournalWriter(Descriptor descriptor) : descriptor_(std::move(descriptor)) {}
  int write(const std::string& record);

  Descriptor descriptor_;
  int error_ = 0;
};

}  // namespace kerf::program
