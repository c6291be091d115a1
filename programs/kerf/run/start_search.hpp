// Looks in a program for a place to start at.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/report/start_report.hpp"

namespace kerf::program {

// What a search came to: the place that was asked for, and where one can start around it.
struct FoundStart {
  StartReport start;
  std::string refused;              // why one cannot start there; empty: one can
  std::optional<LineRound> before;  // the nearest place at which one can, where it is refused
  std::optional<LineRound> after;
};

struct StartSearchOrder {
  const MachineSettings& settings;
  const KernelOptions& options;
  bool knows_answers = true;  // what probes found, is what the simulated machine says now
};

// One can start at a block if the path that is run has a curve or a rest that begins with it, and
// neither a curve of several blocks nor cutter compensation nor a canned cycle is under way, nor
// was a probe whose answer nobody knows.
//
// Reads the file from where it stands, with its path as it is run and without a plan, as far as it
// has to. Preconditions of both: check_program() found no error; the file is rewound. Error: the
// file cannot be read, or the line never runs that often.
tl::expected<FoundStart, std::string> find_start(ProgramFile& file, const StartSearchOrder& order,
                                                 const StartLine& line);

// The last place at or before the block of the program's run (parser::Move::block) at which one can
// start.
tl::expected<FoundStart, std::string> find_start_before(ProgramFile& file,
                                                        const StartSearchOrder& order,
                                                        std::uint64_t block);

}  // namespace kerf::program
