// The scan of one curve of the program, for its plot: the feedrate allowed over u, where it turns,
// and the feedrate that was run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lookahead/path/path_sample.hpp"
#include "programs/kerf/report/min_max_series.hpp"
#include "programs/kerf/report/tick_record.hpp"

namespace kerf::program {

class ScannedCurve {
 public:
  // line: of the program. scan: two samples at least.
  ScannedCurve(std::uint32_t line, lookahead::VelocityLimitCurve scan);

  // Keeps the tick where it is on the curve, the first time that the line is run.
  void add(const TickRecord& record);

  [[nodiscard]] std::uint32_t line() const noexcept { return line_; }
  [[nodiscard]] const lookahead::VelocityLimitCurve& scan() const noexcept { return scan_; }
  // Samples of the scan, ascending: its ends, its valleys, and where hills between them end to rise
  // and begin to fall. Between two of them lies a block of [Sigmoid, section 3.2].
  [[nodiscard]] const std::vector<std::size_t>& breaking_points() const noexcept {
    return breaking_points_;
  }
  // Over shares of the parameter, in kSteps of a step each.
  [[nodiscard]] const MinMaxSeries& planned() const noexcept { return planned_; }
  static constexpr double kSteps = 1e7;
  [[nodiscard]] double share_of(double u) const noexcept {
    return (u - scan_.front().u) / (scan_.back().u - scan_.front().u);
  }

 private:
  std::uint32_t line_;
  lookahead::VelocityLimitCurve scan_;
  std::vector<std::size_t> breaking_points_;
  MinMaxSeries planned_;
  std::int64_t last_step_ = -1;
};

}  // namespace kerf::program
