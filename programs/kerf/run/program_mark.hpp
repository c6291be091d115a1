// Tells whether a program is the one that it was: its text, that of its subprograms, how they are
// read, and where the tool begins.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/io/program_file.hpp"

namespace kerf::program {

class ProgramMark {
 public:
  ProgramMark() = default;
  ProgramMark(const ProgramMark&) = delete;
  ProgramMark& operator=(const ProgramMark&) = delete;

  // Notes the texts that come from it, as they are when they come first. The mark outlives what it
  // gives.
  [[nodiscard]] SubprogramSource noting(SubprogramSource subprograms);

  // Of the program and of all subprograms so far: call it after a check. The file is read from its
  // begin to its end. Error: it cannot be read.
  [[nodiscard]] tl::expected<std::uint64_t, std::string> of(ProgramFile& file,
                                                            const KernelOptions& options) const;

 private:
  std::map<std::string, std::uint64_t, std::less<>> subprograms_;
};

}  // namespace kerf::program
