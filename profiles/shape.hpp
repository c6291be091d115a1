// Any of the shapes, by value.
#pragma once

#include <type_traits>
#include <variant>

#include "profiles/quintic.hpp"
#include "profiles/s_curve.hpp"
#include "profiles/sigmoid.hpp"
#include "profiles/sine.hpp"
#include "profiles/sine_series.hpp"
#include "profiles/trapezoid.hpp"

namespace kerf::profiles {

using Shape = std::variant<Trapezoid, SCurve, Sine, Quintic, SineSeries, Sigmoid>;

static_assert(std::is_trivially_copyable_v<Shape>);
static_assert(sizeof(Shape) <= 40);

}  // namespace kerf::profiles
