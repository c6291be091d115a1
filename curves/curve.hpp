// The curves a program can be made of: exact, valid by construction, parametrised by arc length.
#pragma once

#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

#include <tl/expected.hpp>

#include "curves/arc.hpp"
#include "curves/curve_error.hpp"
#include "curves/line.hpp"
#include "curves/nurbs_curve.hpp"
#include "curves/nurbs_piece.hpp"

namespace kerf::curves {

// A piece is evaluated on the tick side: trivially copyable, s counted from the start of its curve.
using Piece = std::variant<Line, Arc, NurbsPiece>;
static_assert(std::is_trivially_copyable_v<Piece>);

// A curve is planned by the look-ahead. A NurbsCurve holds its pieces in order.
using Curve = std::variant<Line, Arc, NurbsCurve>;

// s_mm outside the piece's or the curve's range is clamped. At s >= length the answer is the
// programmed end, exactly.
Position position_at(const Piece& piece, double s_mm) noexcept;
PathDerivatives derivatives_at(const Piece& piece, double s_mm) noexcept;
// Arc lengths, from the start of the curve, that the piece covers.
double s_begin_mm(const Piece& piece) noexcept;
double s_end_mm(const Piece& piece) noexcept;

double length_mm(const Curve& curve) noexcept;
Position position_at(const Curve& curve, double s_mm) noexcept;
PathDerivatives derivatives_at(const Curve& curve, double s_mm) noexcept;
Extents extents(const Curve& curve);
// From begin_mm to end_mm along it. Precondition: 0 <= begin < end <= length. Nothing: it is too
// short to be a curve.
std::optional<Curve> part(const Curve& curve, const Stretch& stretch);

// Calls use(const Piece&) for the pieces of the curve in order.
template <typename Use>
void for_each_piece(const Curve& curve, Use&& use) {
  if (const auto* nurbs = std::get_if<NurbsCurve>(&curve)) {
    for (const NurbsPiece& piece : nurbs->pieces()) {
      use(Piece(piece));
    }
  } else if (const auto* arc = std::get_if<Arc>(&curve)) {
    use(Piece(*arc));
  } else {
    use(Piece(*std::get_if<Line>(&curve)));
  }
}

}  // namespace kerf::curves
