// What a probe touches on a simulated table. Nothing here allocates, and every loop has a bound.
#pragma once

#include <optional>

#include <kerf/simulation.hpp>

#include "curves/position.hpp"

namespace kerf::machine {

using curves::Position;

// What `of` says of the one that the surface is.
template <typename Of>
auto visit(const TouchSurface& surface, const Of& of) noexcept {
  switch (surface.shape) {
    case TouchSurface::Shape::plane:
      return of(surface.plane);
    case TouchSurface::Shape::sphere:
      return of(surface.sphere);
    case TouchSurface::Shape::height_map:
      return of(surface.height_map);
    default:
      return of(surface.box);
  }
}

// The tip is in what can be touched or on its face, but for rounding.
[[nodiscard]] bool touches(const TouchSurface& surface, const Position& tip_mm) noexcept;

// Of a tip, straight.
struct TipWay {
  const Position& from_mm;
  const Position& to_mm;
};

// Where the way first meets the surface; nothing where it does not. Precondition: it does not begin
// in contact.
[[nodiscard]] std::optional<Position> first_contact(const TouchSurface& surface,
                                                    const TipWay& way) noexcept;

// Where the way first leaves the surface; nothing where it ends in contact. Precondition: it begins
// in contact.
[[nodiscard]] std::optional<Position> end_of_contact(const TouchSurface& surface,
                                                     const TipWay& way) noexcept;

}  // namespace kerf::machine
