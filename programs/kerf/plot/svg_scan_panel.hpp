// The panel of a plot that shows how a curve was scanned.
#pragma once

#include "programs/kerf/plot/scanned_curve.hpp"
#include "programs/kerf/plot/svg_canvas.hpp"

namespace kerf::program {

// The allowed feedrate over u with its breaking points and the ends of blocks, and the feedrate
// that was run.
void draw_scan_panel(SvgCanvas& canvas, const PixelBox& frame, const ScannedCurve& curve);

}  // namespace kerf::program
