// Corners to blends: path segments in, path segments out, with a look ahead of two.
#pragma once

#include <optional>
#include <vector>

#include "curves/curve.hpp"
#include "smoothing/blend.hpp"
#include "smoothing/path_deviations.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// By which blends are sized. Infinity: does not bind.
struct BlendSettings {
  double acceleration_mm_s2 = 0.0;  // of the weakest axis
  double jerk_mm_s3 = 0.0;
  std::optional<curves::Extents> travel{};  // what of it no blend leaves
};

// A corner is blended where both its segments are in G64 with a tolerance, and the lesser of their
// tolerances counts. The blend is as large as the tolerance allows, or as the feedrate needs if
// that is less, and takes of each segment half its length at the most, or what the segment's other
// corner leaves. Corners that nearly turn back are left as they are, for a stop.
class Blender {
 public:
  explicit Blender(const BlendSettings& settings) : settings_(settings) {}

  void push(PathSegment segment, std::vector<PathSegment>& out);
  // What is held back leaves, up to its programmed end.
  void flush(std::vector<PathSegment>& out);

  [[nodiscard]] const PathDeviations& deviations() const noexcept { return deviations_; }

 private:
  struct Held {
    PathSegment segment;
    double length_mm = 0.0;
    double cut_begin_mm = 0.0;  // what the blend before it has taken
    bool follows_blend = false;
    bool is_gone = false;    // blends have taken all of it
    double wanted_mm = 0.0;  // by the corner at its begin
  };
  struct Chosen {
    Blend blend;
    double way_mm = 0.0;
  };

  [[nodiscard]] double wanted_way_mm(const Held& before, const Held& after) const;
  // The largest blend up to way_mm that stays within the tolerance.
  [[nodiscard]] std::optional<Chosen> choose(const Held& before, const Held& after, double way_mm);
  // Decides the corner between the two held segments and lets the first go.
  void settle(double wanted_at_end_mm, std::vector<PathSegment>& out);
  void emit_rest_of(Held& held, double cut_end_mm, std::vector<PathSegment>& out) const;
  void emit_blend(Chosen chosen, const Held& before, Held& after,
                  std::vector<PathSegment>& out) const;

  BlendSettings settings_;
  std::optional<Held> first_;
  std::optional<Held> second_;
  PathDeviations deviations_;
};

}  // namespace kerf::smoothing
