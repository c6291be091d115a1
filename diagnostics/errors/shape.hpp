// Pages of what Fanuc has to place a program: G54.1, G51, G68.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kExtendedOffsetNumber{
    920,
    Severity::error,
    "G54.1 with a wrong P",
    "G54.1 chooses one of 300 further work offsets, and P says which. G10 L20 P writes them.",
    "Write P1 to P300.",
    "G54.1 P500\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kScaleZero{
    921,
    Severity::error,
    "scale out of range",
    "G51 multiplies distances with P, or with I, J and K axis by axis. With 0 the part would be a "
    "point. A factor without a decimal point counts in thousandths.",
    "Write a factor from 0.00001 to 1000; a negative one mirrors.",
    "G51 X0 Y0 P0\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kTurnWithoutAngle{
    922,
    Severity::error,
    "G68 without an angle",
    "G68 turns the program about X Y by the angle R in degrees, and R is missing.",
    "Write R.",
    "G68 X0 Y0\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kTurnPlane{
    923,
    Severity::error,
    "G68 outside the XY plane",
    "The program can be turned about Z. A turn about X or Y would need a machine that tilts.",
    "Use G68 with G17.",
    "G18\nG68 X0 Z0 R30\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kOffsetUnderShape{
    924,
    Severity::error,
    "G52 or G92 while the program is scaled, mirrored or turned",
    "Whether the new origin counts before or after the turn cannot be told, and controls differ.",
    "Set the offset before G51, G51.1 or G68, or after G50, G50.1 or G69.",
    "G68 X0 Y0 R30\nG52 X5\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kArcUnevenlyScaled{
    925,
    Severity::error,
    "arc scaled differently along its axes",
    "Under a G51 whose factors differ, a circle becomes an ellipse, which G2 and G3 are not.",
    "Use the same factor for both axes of the plane; their signs may differ.",
    "G51 X0 Y0 I2. J1.\nG2 X2 I1 F100\nM2\n",
    "fanuc"};

inline constexpr ErrorPage kMirrorUnderShape{
    926,
    Severity::error,
    "mirror changed while the program is scaled or turned",
    "The mirror of G51.1 is around G51 and G68: it is set before them and ended after them, as on "
    "the control.",
    "Write G69 and G50 first, then G51.1 or G50.1, then scale and turn again.",
    "G68 X0 Y0 R30\nG51.1 X0\nM2\n",
    "fanuc"};

inline constexpr std::array kShapePages{
    &kMirrorUnderShape, &kExtendedOffsetNumber, &kScaleZero,        &kTurnWithoutAngle,
    &kTurnPlane,        &kOffsetUnderShape,     &kArcUnevenlyScaled};

}  // namespace kerf::errors
