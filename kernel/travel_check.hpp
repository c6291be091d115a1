// Checks programmed moves against the soft limits.
#pragma once

#include <optional>
#include <vector>

#include <kerf/machine.hpp>

#include "machine/envelope.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf {

class TravelCheck {
 public:
  explicit TravelCheck(const MachineSettings& settings);

  // How far the move leaves the travel. Nothing: it does not, or is no valid curve.
  std::optional<machine::TravelExcess> excess_of(const parser::Move& move);

 private:
  machine::Envelope envelope_;
  machine::AuxiliaryEnvelope extra_envelope_;
  std::vector<smoothing::PathSegment> segments_;  // of the move
};

}  // namespace kerf
