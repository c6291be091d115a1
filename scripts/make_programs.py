#!/usr/bin/env python3
"""Writes the part programs that follow from data: the curves of tests/programs/curves, the polygon, the pocket, the raster.

    make_programs.py [FOLDER]

FOLDER is where the programs go (default: programs/ of this checkout). The same data give the same bytes everywhere;
a test holds the committed programs against a fresh run. Python standard library only.
"""
import json
import math
import pathlib
import sys
from decimal import Decimal

ROOT = pathlib.Path(__file__).resolve().parent.parent
CURVES = ROOT / "tests" / "programs" / "curves"

TITLES = {
    "butterfly": "butterfly, the benchmark curve of the feedrate papers",
    "circle": "exact circle of 1 mm radius, four rational arcs, double inner knots",
    "mazatrol": "Mazatrol curve",
    "rational4": "rational arc-like curve with four control points",
    "scroll": "scroll, 221 control points",
    "star": "star, degree 2",
    "trident7": "trident, seven control points",
    "wm": "WM-like curve, degree 2, eight control points",
}


def number(value):
    """The shortest decimal text that reads back as the same double: with a point, without an exponent, no negative zero."""
    text = format(Decimal(repr(float(value) + 0.0)), "f")
    return text.rstrip("0") if "." in text else text + "."


def point(position):
    return " ".join(axis + number(value) for axis, value in zip("XYZ", position))


def head(title, source, start):
    return [f"({title})", f"(source: {source})", "G21 G90 G17 G61", "G0 " + point(start), "S12000 M3"]


def data_file(curve):
    return "tests/programs/curves/" + curve["name"] + ".json"


def fanuc(curve):
    """G6.2 as Fanuc reads it: P is the order, a knot K in each block, weights R, closed by P blocks that hold a knot only."""
    order, knots = curve["degree"] + 1, curve["knots"]
    rational = any(weight != 1.0 for weight in curve["weights"])
    lines = head(TITLES[curve["name"]], data_file(curve), curve["control_points"][0])
    for i, (position, weight) in enumerate(zip(curve["control_points"], curve["weights"])):
        block = f"K{number(knots[i])} {point(position)}"
        if rational:
            block += " R" + number(weight)
        lines.append(f"G6.2 P{order} {block} F6000." if i == 0 else block)
    lines += ["K" + number(knot) for knot in knots[-order:]]
    return lines + ["M5", "M30"]


def linuxcnc(curve):
    """G6.2 as LinuxCNC reads it: Q chooses its interpolation, every block has R, closing blocks repeat G6.2, knots are integers.

    Scaling all knots by one factor changes the parameter and not the curve, so decimal knots become integers exactly.
    """
    order = curve["degree"] + 1
    exact = [Decimal(repr(knot)) for knot in curve["knots"]]
    scale = 10 ** max(-knot.normalize().as_tuple().exponent for knot in exact)
    knots = [int(knot * scale) for knot in exact]
    lines = head(TITLES[curve["name"]] + ", LinuxCNC form", data_file(curve), curve["control_points"][0])
    lines.insert(2, f"(knots times {scale}: LinuxCNC takes integers only, and the curve does not depend on the factor)")
    lines.append("F6000")
    for i, (position, weight) in enumerate(zip(curve["control_points"], curve["weights"])):
        block = f"{point(position)} R{number(weight)} K{knots[i]}"
        lines.append(f"G6.2 {block} P{order} Q1" if i == 0 else block)
    lines += [f"G6.2 K{knot}" for knot in knots[-order:]]
    return lines + ["M5", "M30"]


# The paper gives no corners. Its largest axial feedrates are 800 cos 11.25 and 800 sin 56.25 degrees (table 3), and its
# corner feedrates (table 2) are A Ts / (2 sin(turn / 2)) of turns by 67.5, 123.75 and 90 degrees, so its legs run in
# multiples of 11.25 degrees. A hexagon whose halves mirror each other, with these turns and no leg nearer to Y, has these
# directions; the lengths are our own.
POLYGON_START = (70.0, 30.0)
POLYGON_LEGS = [(236.25, 30.0), (168.75, 40.0), (45.0, None), (135.0, None), (11.25, 40.0), (-56.25, 30.0)]  # degrees, mm
CORNER_FEEDRATES = {"B": 674, "C": 425, "D": 530, "E": 425, "F": 674}  # mm/min


def polygon_corners():
    """A to F and A again. Both legs at D are as long as it takes to come to D at the height of A."""
    height = sum(length * math.sin(math.radians(angle)) for angle, length in POLYGON_LEGS[:2])
    middle = -height / math.sin(math.radians(POLYGON_LEGS[2][0]))
    corners = [POLYGON_START]
    for angle, length in POLYGON_LEGS:
        (x, y), way = corners[-1], length if length is not None else middle
        corners.append((x + way * math.cos(math.radians(angle)), y + way * math.sin(math.radians(angle))))
    return [(round(x, 6), round(y, 6)) for x, y in corners[:-1]] + [POLYGON_START]


def polygon():
    corners = polygon_corners()
    lines = head("closed polygon, legs in multiples of 11.25 degrees, exact path",
                 "directions from tables 2 and 3 of Chen, Yeh and Sun, doi 10.3722/cadaps.2011.583-592; lengths are our own",
                 corners[0])
    lines += ["G61", "F800."]
    for name, corner in zip("BCDEFA", corners[1:]):
        feedrate = f" (corner {name}: {CORNER_FEEDRATES[name]} mm/min in the paper)" if name in CORNER_FEEDRATES else " (A)"
        lines.append("G1 " + point(corner) + feedrate)
    return lines + ["M5", "M30"]


def ring(half_x, half_y, corner, centre_form):
    """A rounded rectangle, climb milled inside a pocket: counter-clockwise from the middle of its right side and back."""
    word = (lambda i, j: f"I{number(i)} J{number(j)}") if centre_form else (lambda i, j: f"R{number(corner)}")
    x, y = half_x - corner, half_y - corner
    return [
        f"G1 Y{number(y)}", f"G3 X{number(x)} Y{number(half_y)} {word(-corner, 0)}",
        f"G1 X{number(-x)}", f"G3 X{number(-half_x)} Y{number(y)} {word(0, -corner)}",
        f"G1 Y{number(-y)}", f"G3 X{number(-x)} Y{number(-half_y)} {word(corner, 0)}",
        f"G1 X{number(x)}", f"G3 X{number(half_x)} Y{number(-y)} {word(0, corner)}",
        "G1 Y0.",
    ]


def pocket():
    """A pocket of 60 x 40 x 4 mm for a 6 mm cutter: helical entry, rings outwards at two depths, arc on and off the wall."""
    lines = ["(pocket 60 x 40 x 4 mm with corner radius 8 mm, cutter of 6 mm, climb milling)", "(source: Kerf's own)",
             "G21 G90 G17 G94 G40 G61", "S9000 M3", "M8", "G0 Z5.", "G0 X7. Y0."]
    depth, step = 0.0, 2.0
    while depth < 4.0:
        floor = depth + step
        lines += [f"(level Z{number(-floor)})", f"G0 Z{number(1.0 - depth)}", f"G1 Z{number(-depth)} F400."]
        for quarter in range(1, 5):  # one turn for each half millimetre, radius 4 mm about X3 Y0
            lines.append(f"G3 X7. Y0. Z{number(-(depth + step * quarter / 4))} I-4. J0." + (" F600." if quarter == 1 else ""))
        lines.append("G3 I-4. J0. (flatten the floor under the helix)")
        lines.append("G1 X-11. Y0. F1200.")
        for inset in (13.0, 9.0, 5.0, 0.5):
            half_x, half_y, corner = 27.0 - inset, 17.0 - inset, max(2.0, 5.0 - inset)
            lines.append(f"G1 X{number(half_x)} Y0.")
            lines += ring(half_x, half_y, corner, centre_form=inset > 1.0)
        lines += ["(finish the wall)", "G1 X24. Y-3.", "G3 X27. Y0. R3. F900."]
        lines += ring(27.0, 17.0, 5.0, centre_form=True)
        lines += ["G3 X24. Y3. I-3. J0.", "G1 X7. Y0. F1200."]
        depth = floor
    return lines + ["G0 Z5.", "G0 X0. Y0.", "M9", "M5", "M30"]


def surface(x, y):
    return -3.0 + 1.6 * math.sin(x / 7.0) * math.cos(y / 9.0) + 0.9 * math.exp(-((x - 38.0) ** 2 + (y - 22.0) ** 2) / 60.0)


def raster():
    """Rows along X over a wavy surface, there and back; points every 0.8 mm, rows 1 mm apart: 76 x 41 points."""
    columns, rows = 76, 41
    lines = ["(3-D raster finishing pass over a wavy surface, 60 x 40 mm, rows 1 mm apart)", "(source: Kerf's own)",
             "G21 G90 G17 G94 G64 P0.005", "S12000 M3", "G0 Z5.", "G0 X0. Y0.", f"G1 Z{surface(0, 0):.3f} F600.", "F3000."]
    for row in range(rows):
        order = range(columns) if row % 2 == 0 else reversed(range(columns))
        for column in order:
            if row or column:
                x, y = 0.8 * column, float(row)
                lines.append(f"G1 X{x:.3f} Y{y:.3f} Z{surface(x, y):.3f}")
    return lines + ["G0 Z5.", "M5", "M30"]


def programs():
    """Name and lines of every program."""
    for path in sorted(CURVES.glob("*.json")):
        curve = json.loads(path.read_text(encoding="utf-8"))
        yield curve["name"], fanuc(curve)
        if curve["name"] == "butterfly":
            yield "butterfly-linuxcnc", linuxcnc(curve)
    yield "polygon", polygon()
    yield "pocket", pocket()
    yield "raster", raster()


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "programs"
    for name, lines in programs():
        (folder / (name + ".ngc")).write_bytes(("\n".join(lines) + "\n").encode("ascii"))


if __name__ == "__main__":
    main()
