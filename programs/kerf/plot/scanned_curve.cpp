#include "programs/kerf/plot/scanned_curve.hpp"

#include <algorithm>
#include <utility>

#include "lookahead/classical/limit_curve_cuts.hpp"

namespace kerf::program {

namespace {

// Of the feedrate: what is no higher than the top by more belongs to the hill's flat.
constexpr double kFlat = 1e-3;

std::vector<std::size_t> turns_of(const lookahead::VelocityLimitCurve& scan) {
  std::vector<std::size_t> feet{0};
  for (const std::size_t valley : lookahead::valleys(scan, lookahead::breaking_points(scan, 0.0))) {
    feet.push_back(valley);
  }
  feet.push_back(scan.size() - 1);
  std::vector<std::size_t> turns;
  for (std::size_t k = 1; k < feet.size(); ++k) {
    const auto first = scan.begin() + static_cast<std::ptrdiff_t>(feet[k - 1]);
    const auto last = scan.begin() + static_cast<std::ptrdiff_t>(feet[k]) + 1;
    const double top = std::max_element(first, last, [](const auto& a, const auto& b) {
                         return a.v_mm_s < b.v_mm_s;
                       })->v_mm_s;
    const auto is_flat = [&](const lookahead::FeedSample& at) {
      return at.v_mm_s >= top * (1.0 - kFlat);
    };
    const auto begin = std::find_if(first, last, is_flat);
    const auto end =
        std::find_if(std::reverse_iterator(last), std::reverse_iterator(first), is_flat);
    turns.push_back(feet[k - 1]);
    turns.push_back(static_cast<std::size_t>(begin - scan.begin()));
    turns.push_back(static_cast<std::size_t>(end.base() - 1 - scan.begin()));
  }
  turns.push_back(scan.size() - 1);
  turns.erase(std::unique(turns.begin(), turns.end()), turns.end());
  return turns;
}

}  // namespace

ScannedCurve::ScannedCurve(std::uint32_t line, lookahead::VelocityLimitCurve scan)
    : line_(line), scan_(std::move(scan)), breaking_points_(turns_of(scan_)) {}

void ScannedCurve::add(const TickRecord& record) {
  if (record.line != line_ || !record.detail.curve_parameter) {
    return;
  }
  const double share = share_of(*record.detail.curve_parameter);
  const auto step = static_cast<std::int64_t>(std::clamp(share, 0.0, 1.0) * kSteps);
  if (step > last_step_) {
    planned_.add(step, record.motion.v_mm_s);
    last_step_ = step;
  }
}

}  // namespace kerf::program
