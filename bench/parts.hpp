// Programs of short segments: their time, limits and deviation, and what they cost to run.
#pragma once

#include <string>

#include "profiles/profile.hpp"

namespace kerf::bench {

struct PartsOrder {
  bool quick = false;      // without exact stops at tens of thousands of short lines
  bool with_long = false;  // ten million lines, too
  std::string only;        // "cost", or the programs whose name begins so; empty: all
  profiles::ProfileKind profile = profiles::kDefaultProfile;
};

// Prints the tables. 1: a target was missed.
int parts(const PartsOrder& order);

// Of parts: dry runs with ticks to nowhere, each in a process of its own for its memory.
bool parts_cost(const PartsOrder& order);
// Of parts: smoothing alone.
bool parts_smoothing(const PartsOrder& order);

}  // namespace kerf::bench
