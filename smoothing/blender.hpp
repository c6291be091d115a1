// Rounds corners: path segments in, path segments out, with a look-ahead of two.
#pragma once

#include <optional>
#include <vector>

#include "curves/curve.hpp"
#include "smoothing/blend.hpp"
#include "smoothing/path_deviations.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// The limits by which blends are sized. An infinite limit does not bind.
struct BlendSettings {
  double acceleration_mm_s2 = 0.0;  // of the weakest axis
  double jerk_mm_s3 = 0.0;
  std::optional<curves::Extents> travel{};  // no blend leaves it
};

// It is in G64 with a tolerance, and X, Y and Z move alone.
bool may_bend(const PathSegment& segment);

// What a blend takes of each side so that the jump of the curvature alone takes no more than the
// jerk at this feedrate.
double way_through_jump_mm(const CornerShape& shape, double feedrate_mm_s,
                           const BlendSettings& settings);

// A corner is blended if both its segments are in G64 with a tolerance; the smaller tolerance
// counts. The blend is as large as the tolerance allows, or as the feedrate needs if that is less.
// It takes at most half of each segment, or what the segment's other corner leaves. Corners that
// nearly turn back stay as they are, for a stop.
class Blender {
 public:
  explicit Blender(const BlendSettings& settings) : settings_(settings) {}

  void push(PathSegment segment, std::vector<PathSegment>& out);
  // Releases the held segments, up to their programmed end.
  void flush(std::vector<PathSegment>& out);

  // Corners between two blocks of the program that are not released yet stay as they are.
  void keep_blocks_apart(bool on) noexcept { keeps_blocks_apart_ = on; }

  [[nodiscard]] const PathDeviations& deviations() const noexcept { return deviations_; }

 private:
  struct Held {
    PathSegment segment;
    double length_mm = 0.0;
    double cut_begin_mm = 0.0;  // the blend before has taken this much
    bool follows_blend = false;
    bool is_gone = false;    // blends have taken all of it
    double wanted_mm = 0.0;  // by the corner at its begin
  };
  struct Chosen {
    Blend blend;
    double way_mm = 0.0;
    double deviation_mm = 0.0;
  };

  static bool are_of_two_blocks(const Held& before, const Held& after);
  [[nodiscard]] double wanted_way_mm(const Held& before, const Held& after) const;
  // The largest blend up to way_mm that stays within the tolerance.
  [[nodiscard]] std::optional<Chosen> choose(const Held& before, const Held& after, double way_mm);
  // Decides on the corner between the two held segments and releases the first.
  void settle(double wanted_at_end_mm, std::vector<PathSegment>& out);
  void emit_rest_of(Held& held, double cut_end_mm, std::vector<PathSegment>& out) const;
  void emit_blend(Chosen chosen, const Held& before, Held& after,
                  std::vector<PathSegment>& out) const;

  BlendSettings settings_;
  bool keeps_blocks_apart_ = false;
  std::optional<Held> first_;
  std::optional<Held> second_;
  PathDeviations deviations_;
};

}  // namespace kerf::smoothing
