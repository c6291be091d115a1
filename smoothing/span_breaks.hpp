// Where the spans of a run's spline end: at vertices, closer together where the run turns.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "smoothing/polyline.hpp"

namespace kerf::smoothing {

class SpanBreaks {
 public:
  struct Settings {
    std::size_t last = 0;       // vertex; the first is 0
    double before_mm = 0.0;     // length of the span that the spline goes on from; 0: of none
    double tolerance_mm = 0.0;  // of merging
  };

  // given: the first of them, as an earlier fit had them; may be none.
  SpanBreaks(const Polyline& run, std::span<const std::size_t> given, const Settings& settings);

  // In order, from 0 to the last.
  [[nodiscard]] const std::vector<std::size_t>& vertices() const noexcept { return vertices_; }
  [[nodiscard]] std::size_t span_count() const noexcept { return vertices_.size() - 1; }

  // Half of a span may not be too short beside what came before and cannot be divided any more.
  [[nodiscard]] bool is_divisible(std::size_t span) const;
  // Each of these spans becomes two, and so do neighbours that would be long beside them.
  // Precondition: they are divisible, and there is a flag for each span.
  void divide(std::vector<bool> spans);

 private:
  [[nodiscard]] double w_mm(std::size_t vertex) const { return (*run_)[vertex].w_mm; }
  [[nodiscard]] double length_mm(std::size_t span) const {
    return w_mm(vertices_[span + 1]) - w_mm(vertices_[span]);
  }
  void place();
  void grade(std::vector<bool>& spans) const;

  const Polyline* run_;
  Settings settings_;
  std::vector<std::size_t> vertices_;
};

}  // namespace kerf::smoothing
