// Pages of probing.
#pragma once

#include <array>

#include "diagnostics/errors/error_page.hpp"

namespace kerf::errors {

inline constexpr ErrorPage kProbeWithoutAxis{
    850,
    Severity::error,
    "probing without an axis word",
    "G38.2 to G38.5 probe on the way to the place that the block names.",
    "Write where the probe is to go at the most.",
    "F100\nG38.2\nM2\n"};

inline constexpr ErrorPage kProbeWithoutWay{
    851,
    Severity::error,
    "probing without a way",
    "The place that the block names is where the tool already is, so there is no direction to "
    "probe in.",
    "Name a place behind the surface that is to be found.",
    "F100\nG0 Z5\nG38.2 Z5\nM2\n"};

inline constexpr ErrorPage kProbeTouching{
    852,
    Severity::error,
    "probing towards contact begins in contact",
    "G38.2 and G38.3 end where the probe meets the workpiece; a probe that touches it already has "
    "no such place.",
    "Retract before probing, or use G38.4 to find where contact ends.",
    "F100\nG0 Z-160\nG38.2 Z-170\nM2\n"};

inline constexpr ErrorPage kProbeNotTouching{
    853,
    Severity::error,
    "probing away from contact begins without contact",
    "G38.4 and G38.5 end where the probe leaves the workpiece, so it must touch it before.",
    "Probe towards the workpiece first (G38.2); see [probe] in the machine file for what there is "
    "to touch.",
    "F100\nG38.4 Z10\nM2\n"};

inline constexpr ErrorPage kProbeInVain{
    854,
    Severity::error,
    "probing found nothing",
    "G38.2 ended without contact, or G38.4 still in contact. The simulated table touches what "
    "[probe] in the machine file describes, and nothing where the file has none.",
    "Let the block lead further, or describe the surface in [probe]; G38.3 and G38.5 go on and "
    "leave 0 in #5070 instead.",
    "F100\nG38.2 Z-10\nM2\n"};

inline constexpr std::array kProbingPages{&kProbeWithoutAxis, &kProbeWithoutWay, &kProbeTouching,
                                          &kProbeNotTouching, &kProbeInVain};

}  // namespace kerf::errors
