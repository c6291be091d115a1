// The path that is planned, before any time is known: how far it is from the programmed one, place
// by place, which file it comes from, and where it goes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "programs/kerf/page/timed_path.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::program {

// The longest side of the box.
[[nodiscard]] double size_mm(const curves::Extents& extents);
// How far drawn paths of this size may be from what they stand for, as long as there are points.
[[nodiscard]] double drawn_tolerance_mm(const curves::Extents& extents);

class PlannedPath {
 public:
  static constexpr std::size_t kMaxSteps = 200'000;

  // extents: of the whole path.
  explicit PlannedPath(const curves::Extents& extents);

  // Segments and pauses in their order.
  void add(const smoothing::PathSegment& segment);
  void add_pause(const diagnostics::SourcePosition& source) { enter(source.file, source.line); }

  // Up to here along the path, from where the step before ends.
  struct Step {
    double end_mm = 0.0;
    double deviation_mm = 0.0;  // the largest there
  };
  // Neighbours differ. Where the steps run out, two become one, with the larger deviation.
  [[nodiscard]] const std::vector<Step>& deviations() const noexcept { return steps_; }

  // From here along the path on it comes from these lines of a file: 0 is the program, others are
  // subprograms'.
  struct Part {
    double begin_mm = 0.0;
    std::uint16_t file = 0;
    std::uint32_t first_line = 0;
    std::uint32_t last_line = 0;

    [[nodiscard]] bool has(std::uint32_t line) const noexcept {
      return first_line <= line && line <= last_line;
    }
  };
  // Behind kMaxSteps of them they end: what follows counts as the last.
  [[nodiscard]] const std::vector<Part>& parts() const noexcept { return parts_; }

  // Points as of a run, but "ticks" are nanometres along the path: no time is known.
  [[nodiscard]] const TimedPath& outline() const noexcept { return outline_; }

 private:
  void enter(std::uint16_t file, std::uint32_t line);
  void add_step(const Step& step);
  void add_point(const TimedPoint& point);

  double size_mm_;
  double length_mm_ = 0.0;
  std::vector<Step> steps_;
  std::vector<Part> parts_;
  TimedPath outline_;
  std::int64_t last_tick_ = -1;
};

// The deviation at each tick of a run. Refers to the path.
class DeviationAlong {
 public:
  explicit DeviationAlong(const PlannedPath* path) : path_(path) {}

  // The largest between the place before and this one, which is not behind it. 0 without a path.
  double advance_to(double s_mm);

 private:
  const PlannedPath* path_;
  std::size_t step_ = 0;
};

// The file of each tick of a run. Refers to the path.
class FileAlong {
 public:
  explicit FileAlong(const PlannedPath* path) : path_(path) {}

  // At this place, which is not before the last one, in this line. 0 without a path.
  std::uint16_t advance_to(double s_mm, std::uint32_t line);

 private:
  const PlannedPath* path_;
  std::size_t part_ = 0;
};

}  // namespace kerf::program
