// A move that cutter compensation holds until it knows what follows.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "diagnostics/diagnostic_list.hpp"
#include "parser/compensation/corner.hpp"
#include "parser/moves/move.hpp"

namespace kerf::parser {

// What a move is to the contour. Idle ones do not move in the plane.
enum class HeldRole : std::uint8_t { idle, entry, contour, exit };

// What is wrong with a contour, for the list of diagnostics.
struct ContourFault {
  diagnostics::DiagnosticPlace place;
  const diagnostics::ErrorPage* page;
  std::string message;
};

struct HeldMove {
  Move move;                           // as programmed
  diagnostics::DiagnosticPlace place;  // of curves
  HeldRole role = HeldRole::idle;
  OffsetCurve curve;            // both without regard to corners
  planar::ContourElement wall;  // what is to be kept of curve.programmed
  // Of the tool's centre: curve.path with its ends where the corners put them.
  planar::ContourElement way;
  // The tool first rolls about the corner at the start, along `corner`. An entry has the corner at
  // its end here, to be compared with the contour and not to be sent.
  bool has_corner = false;
  bool corner_is_of_entry = false;  // is sent and not compared
  planar::ContourElement corner;
  double lost_at_start_mm = 0.0;  // of curve.path, to inside corners
  double lost_at_end_mm = 0.0;
  bool lead = false;      // leads in or out: other moves may pass over it, see gouge.cpp
  bool left_out = false;  // only its fault is told
  bool faulty = false;    // not compared any more
  std::optional<ContourFault> fault;  // to be told when the move is sent
  std::uint64_t number = 0;           // counts curves
  std::uint32_t run = 0;  // only moves of the same run can cut into each other; 0: of none
  double low_mm = 0.0;    // along the plane's normal
  double high_mm = 0.0;
};

}  // namespace kerf::parser
