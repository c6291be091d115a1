#include <cassert>
#include <utility>

#include "smoothing/run_fit.hpp"

namespace kerf::smoothing {

using curves::vec;

namespace {

constexpr double kTurnOfSpan_rad = 0.5;
constexpr std::size_t kLinesOfSpan = 32;
constexpr double kGrowth = 3.0;          // of a span over its neighbour
constexpr double kDirectionOver = 10.0;  // tolerances, against noise
constexpr double kGrading = 4.0;         // of a span over its neighbour, after divisions

}  // namespace

SpanBreaks::SpanBreaks(const Polyline& run, std::span<const std::size_t> given,
                       const Settings& settings)
    : run_(&run), settings_(settings), vertices_(given.begin(), given.end()) {
  if (vertices_.empty()) {
    vertices_.push_back(0);
  }
  place();
  vertices_.push_back(settings_.last);
}

// A span ends where the run has turned by kTurnOfSpan_rad since its begin.
void SpanBreaks::place() {
  const double over = kDirectionOver * settings_.tolerance_mm;
  std::size_t from = vertices_.back();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double turned = 0.0;
  for (std::size_t i = from + 1; i < settings_.last; ++i) {
    if (w_mm(i) - w_mm(from) >= over) {
      const Eigen::Vector3d next =
          (vec((*run_)[i].point_mm) - vec((*run_)[from].point_mm)).normalized();
      turned += direction.isZero() ? 0.0 : (next - direction).norm();
      direction = next;
      from = i;
    }
    const std::size_t begin = vertices_.back();
    const std::size_t count = vertices_.size();
    const bool grown =
        count > 1 && w_mm(i) - w_mm(begin) >= kGrowth * (w_mm(begin) - w_mm(vertices_[count - 2]));
    if (turned >= kTurnOfSpan_rad || i - begin >= kLinesOfSpan || grown) {
      vertices_.push_back(i);
      turned = 0.0;
    }
  }
}

bool SpanBreaks::is_divisible(std::size_t span) const {
  const double before = span == 0 ? settings_.before_mm : 0.0;
  return vertices_[span + 1] - vertices_[span] >= 2 && 2.0 * length_mm(span) >= before / kGrading;
}

// Beside a short span no long one: both the fit and its equations are poor there.
void SpanBreaks::grade(std::vector<bool>& spans) const {
  const auto follow = [&](std::size_t span, std::size_t neighbour) {
    if (spans[span] && !spans[neighbour] && is_divisible(neighbour) &&
        length_mm(neighbour) > 0.5 * kGrading * length_mm(span)) {
      spans[neighbour] = true;
    }
  };
  for (std::size_t k = 0; k + 1 < spans.size(); ++k) {
    follow(k, k + 1);
  }
  for (std::size_t k = spans.size() - 1; k > 0; --k) {
    follow(k, k - 1);
  }
}

void SpanBreaks::divide(std::vector<bool> spans) {
  assert(spans.size() == span_count());
  grade(spans);
  std::vector<std::size_t> finer;
  for (std::size_t k = 0; k < span_count(); ++k) {
    finer.push_back(vertices_[k]);
    if (spans[k]) {
      assert(is_divisible(k));
      finer.push_back(vertices_[k] + (vertices_[k + 1] - vertices_[k]) / 2);
    }
  }
  finer.push_back(vertices_.back());
  vertices_ = std::move(finer);
}

}  // namespace kerf::smoothing
