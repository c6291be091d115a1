#include "smoothing/curvature_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "smoothing/blend.hpp"

namespace kerf::smoothing {

using curves::vec;

namespace {

constexpr double kJump = 1e-6;         // of the curvature on both sides
constexpr double kOfTolerance = 0.05;  // that the curve may be beside the lines
constexpr double kBetween = 1.1;       // over what is looked at
constexpr double kEvenLine = 50.0;  // tolerances: longer lines are as long as a part of the piece
constexpr double kMinLines = 2.0;   // of a piece
constexpr double kEvenLines = 16.0;
constexpr double kMaxLines = 64.0;

double curvature_per_mm(const curves::NurbsPiece& piece, double share) {
  const double s_mm = piece.s_begin_mm + share * (piece.s_end_mm - piece.s_begin_mm);
  const curves::PathDerivatives path = piece.derivatives_at(s_mm);
  return vec(path.second_per_mm).norm();
}

// Nothing: too many.
std::optional<int> lines_of(const curves::NurbsPiece& piece, double tolerance_mm) {
  double curvature = 0.0;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    curvature = std::max(curvature, curvature_per_mm(piece, share));
  }
  const double length_mm = piece.s_end_mm - piece.s_begin_mm;
  const double by_height = length_mm * std::sqrt(curvature / (8.0 * kOfTolerance * tolerance_mm));
  const double even = std::min(length_mm / (kEvenLine * tolerance_mm), kEvenLines);
  const double count = std::ceil(std::max({by_height, even, kMinLines}));
  return count <= kMaxLines ? std::optional(static_cast<int>(count)) : std::nullopt;
}

}  // namespace

std::vector<double> curvature_jumps(const curves::NurbsCurve& curve) {
  std::vector<double> jumps_mm;
  const std::vector<curves::NurbsPiece>& pieces = curve.pieces();
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const double s_mm = pieces[i].s_begin_mm;
    const curves::PathDerivatives before = pieces[i - 1].derivatives_at(s_mm);
    const curves::PathDerivatives after = pieces[i].derivatives_at(s_mm);
    const auto in = vec(before.second_per_mm);
    const auto out = vec(after.second_per_mm);
    if ((out - in).norm() > kJump * (out.norm() + in.norm())) {
      jumps_mm.push_back(s_mm);
    }
  }
  return jumps_mm;
}

bool blends_meet(const curves::NurbsCurve& curve, const std::vector<double>& jumps_mm,
                 double feedrate_mm_s, const BlendSettings& settings) {
  double taken_to_mm = 0.0;
  for (const double s_mm : jumps_mm) {
    const std::size_t after = curve.piece_index(s_mm);
    const curves::PathDerivatives in = curve.pieces()[after - 1].derivatives_at(s_mm);
    const curves::PathDerivatives out = curve.pieces()[after].derivatives_at(s_mm);
    const CornerShape shape = shape_between(in, out);
    const double v_mm_s =
        std::min(feedrate_mm_s, std::sqrt(settings.acceleration_mm_s2 / shape.curvature_per_mm));
    const double way_mm = way_through_jump_mm(shape, v_mm_s, settings);
    if (s_mm - way_mm < taken_to_mm) {
      return true;
    }
    taken_to_mm = s_mm + way_mm;
  }
  return taken_to_mm > curve.length_mm();
}

void append_cut(const PathSegment& segment, const std::vector<double>& at_mm,
                std::vector<PathSegment>& out) {
  const auto& curve = std::get<curves::NurbsCurve>(segment.curve);
  PathSegment cut = segment;  // the whole curve is copied once, not for each part
  double begin_mm = 0.0;
  for (std::size_t i = 0; i <= at_mm.size(); ++i) {
    const double end_mm = i < at_mm.size() ? at_mm[i] : curve.length_mm();
    if (auto part = begin_mm < end_mm ? curve.part({begin_mm, end_mm}) : std::nullopt) {
      cut.curve = std::move(*part);
      out.push_back(cut);
      begin_mm = end_mm;
    }
  }
}

SampledCurve sampled(const curves::NurbsCurve& curve, double tolerance_mm) {
  SampledCurve lines;
  curves::Position from = curve.at(0.0);
  for (const curves::NurbsPiece& piece : curve.pieces()) {
    const auto count = lines_of(piece, tolerance_mm);
    if (!count) {
      return {};
    }
    const double length_mm = (piece.s_end_mm - piece.s_begin_mm) / *count;
    for (int k = 0; k < *count; ++k) {
      const double begin_mm = piece.s_begin_mm + k * length_mm;
      const curves::Position to = piece.at(begin_mm + length_mm);
      const curves::Position middle = piece.at(begin_mm + 0.5 * length_mm);
      const Eigen::Vector3d height = vec(middle) - 0.5 * (vec(from) + vec(to));
      lines.beside_mm = std::max(lines.beside_mm, kBetween * height.norm());
      lines.points_mm.push_back(to);
      from = to;
    }
  }
  return lines;
}

}  // namespace kerf::smoothing
