// The data of a run for its plot, in bounded memory.
#pragma once

#include <optional>
#include <utility>

#include "curves/position.hpp"
#include "programs/kerf/plot/path_outline.hpp"
#include "programs/kerf/plot/projection.hpp"
#include "programs/kerf/plot/scanned_curve.hpp"
#include "programs/kerf/plot/sharp_places.hpp"
#include "programs/kerf/report/limit_band.hpp"
#include "programs/kerf/report/min_max_series.hpp"
#include "programs/kerf/report/tick_record.hpp"

namespace kerf::program {

class PlotData {
 public:
  // extents: of what is cut, known before it runs; where nothing is, of the whole path. They set
  // the view and how fine the outline is.
  explicit PlotData(const curves::Extents& extents);

  // From the first tick on the plot keeps the active constraints, too.
  void add_limits() { limits_.emplace(); }
  // Before the first tick: a curve that it shows over u, too.
  void add_scan(ScannedCurve curve) { scan_.emplace(std::move(curve)); }
  void add(const TickRecord& record);

  [[nodiscard]] View view() const noexcept { return view_; }
  [[nodiscard]] const PathOutline& outline() const noexcept { return outline_; }
  [[nodiscard]] const SharpPlaces& sharp_places() const noexcept { return sharp_places_; }
  [[nodiscard]] const MinMaxSeries& v() const noexcept { return v_; }
  [[nodiscard]] const MinMaxSeries& a() const noexcept { return a_; }
  [[nodiscard]] const MinMaxSeries& j() const noexcept { return j_; }
  [[nodiscard]] const MinMaxSeries& chord_error_um() const noexcept { return chord_error_um_; }
  [[nodiscard]] const std::optional<ScannedCurve>& scan() const noexcept { return scan_; }
  [[nodiscard]] const std::optional<LimitBand>& limits() const noexcept { return limits_; }
  // The largest feedrate outside rapids; 0 where there is none.
  [[nodiscard]] double max_feedrate_mm_s() const noexcept { return max_feedrate_mm_s_; }
  [[nodiscard]] std::int64_t last_tick() const noexcept { return last_tick_; }

 private:
  View view_;
  PathOutline outline_;
  SharpPlaces sharp_places_;
  MinMaxSeries v_;
  MinMaxSeries a_;
  MinMaxSeries j_;
  MinMaxSeries chord_error_um_;
  std::optional<ScannedCurve> scan_;
  std::optional<LimitBand> limits_;
  double max_feedrate_mm_s_ = 0.0;
  std::int64_t last_tick_ = 0;
};

}  // namespace kerf::program
