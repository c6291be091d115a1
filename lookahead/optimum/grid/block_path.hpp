// A block as the time optimum sees it: derivatives and the feedrate allowed at each place.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/block_limits.hpp"

namespace kerf::lookahead {

// Refers to both: lives no longer.
class BlockPath {
 public:
  BlockPath(const Block& block, const PlanLimits& limits) : block_(&block), limits_(&limits) {}

  [[nodiscard]] double length_mm() const { return block_->length_mm; }
  // s_mm is clamped. At a place where derivatives jump either side may be given.
  [[nodiscard]] PathSample at(double s_mm) const;
  // The limits along the block, without those of the axes.
  [[nodiscard]] const profiles::RampLimits& along() const { return block_->along.ramp; }
  [[nodiscard]] const LimitOrigins& along_from() const { return block_->along.from; }

  // Places in ascending order, both ends among them, so dense that the bound of the feedrate hardly
  // changes between two of them.
  [[nodiscard]] std::vector<double> scan_places() const;
  // How far from the place the path's derivatives can be taken as one polynomial.
  [[nodiscard]] double piece_mm(double s_mm) const;
  // A line, whose derivatives are the same everywhere, under one feedrate.
  [[nodiscard]] bool is_straight() const {
    return std::holds_alternative<curves::Line>(block_->curve) && block_->limit_curve.empty();
  }
  // Its limits let a motion come down to a lower feedrate.
  [[nodiscard]] bool slows() const { return block_->slows; }
  // Derivatives may jump there.
  [[nodiscard]] bool joins_pieces(double s_mm) const;
  // An inner place where a cell must end: the third derivative jumps, the limit curve has a valley,
  // or curvature jumps by more than rounding leaves (`jump`); or a rest, where the curve turns back
  // within a radius of kStopRadius_mm.
  struct Break {
    double s_mm = 0.0;
    std::optional<Jump> jump{};
    bool valley = false;  // and nothing else
    bool rest = false;
  };
  // Ascending.
  [[nodiscard]] std::vector<Break> breaks() const;

 private:
  // Whether a jump of curvature between pieces takes part in the limits of an axis.
  [[nodiscard]] bool counts(const Jump& jump, double s_mm) const;
  // The limit curve's, which is nowhere above the block's feedrate.
  [[nodiscard]] Bound feedrate_at(double s_mm) const;

  const Block* block_;
  const PlanLimits* limits_;
};

}  // namespace kerf::lookahead
