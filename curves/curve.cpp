#include "curves/curve.hpp"

#include <utility>

namespace kerf::curves {
namespace {

// std::visit may throw on a variant without a value; a curve always has one, so this never does.
template <typename Variant, typename Use>
auto dispatch(const Variant& shape, const Use& use) noexcept {
  if (const auto* line = std::get_if<0>(&shape)) {
    return use(*line);
  }
  if (const auto* arc = std::get_if<1>(&shape)) {
    return use(*arc);
  }
  return use(*std::get_if<2>(&shape));
}

}  // namespace

Position position_at(const Piece& piece, double s_mm) noexcept {
  return dispatch(piece, [s_mm](const auto& shape) noexcept { return shape.at(s_mm); });
}

PathDerivatives derivatives_at(const Piece& piece, double s_mm) noexcept {
  return dispatch(piece, [s_mm](const auto& shape) noexcept { return shape.derivatives_at(s_mm); });
}

double s_begin_mm(const Piece& piece) noexcept {
  const auto* nurbs = std::get_if<NurbsPiece>(&piece);
  return nurbs != nullptr ? nurbs->s_begin_mm : 0.0;
}

double s_end_mm(const Piece& piece) noexcept {
  if (const auto* nurbs = std::get_if<NurbsPiece>(&piece)) {
    return nurbs->s_end_mm;
  }
  if (const auto* arc = std::get_if<Arc>(&piece)) {
    return arc->length_mm();
  }
  return std::get_if<Line>(&piece)->length_mm();
}

double length_mm(const Curve& curve) noexcept {
  return dispatch(curve, [](const auto& shape) noexcept { return shape.length_mm(); });
}

Position position_at(const Curve& curve, double s_mm) noexcept {
  return dispatch(curve, [s_mm](const auto& shape) noexcept { return shape.at(s_mm); });
}

PathDerivatives derivatives_at(const Curve& curve, double s_mm) noexcept {
  return dispatch(curve, [s_mm](const auto& shape) noexcept { return shape.derivatives_at(s_mm); });
}

Extents extents(const Curve& curve) {
  if (const auto* line = std::get_if<Line>(&curve)) {
    return line->extents();
  }
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    return arc->extents();
  }
  return std::get_if<NurbsCurve>(&curve)->extents();
}

std::optional<Curve> part(const Curve& curve, const Stretch& stretch) {
  if (const auto* line = std::get_if<Line>(&curve)) {
    return line->part(stretch);
  }
  if (const auto* arc = std::get_if<Arc>(&curve)) {
    return arc->part(stretch);
  }
  if (auto nurbs = std::get_if<NurbsCurve>(&curve)->part(stretch)) {
    return std::move(*nurbs);
  }
  return std::nullopt;
}

}  // namespace kerf::curves
