#!/usr/bin/env python3
"""The shipped part programs: as their generator writes them, true to the curve data, inside the default travel."""
import importlib.util
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ROOT / "programs"
CURVES = ROOT / "tests" / "programs" / "curves"
TRAVEL_MM = {"X": 500.0, "Y": 500.0, "Z": 200.0}


def words(path):
    """Each block as a list of (letter, number), comments left out."""
    for line in path.read_text(encoding="ascii").splitlines():
        yield [(letter, float(value)) for letter, value in re.findall(r"([A-Z])(-?\d*\.?\d+|-?\d+\.)", re.sub(r"\([^)]*\)", "", line))]


class ShippedPrograms(unittest.TestCase):
    def test_are_what_the_generator_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, ROOT / "scripts" / "make_programs.py", folder], check=True)
            fresh = {path.name: path.read_bytes() for path in pathlib.Path(folder).iterdir()}
        committed = {path.name: path.read_bytes() for path in PROGRAMS.glob("*.ngc")}
        self.assertEqual(sorted(fresh), sorted(committed))
        for name, content in fresh.items():
            self.assertEqual(content, committed[name], f"{name}: run scripts/make_programs.py and commit what it writes")

    def test_say_the_same_curve_as_the_data(self):
        for path in sorted(CURVES.glob("*.json")):
            curve = json.loads(path.read_text())
            for suffix, scale in (("", 1), ("-linuxcnc", 10000)):
                program = PROGRAMS / (curve["name"] + suffix + ".ngc")
                if not program.exists():
                    self.assertEqual(suffix, "-linuxcnc")
                    continue
                blocks = [dict(block) for block in words(program) if any(letter == "K" for letter, _ in block)]
                points = [block for block in blocks if "X" in block]
                self.assertEqual([[b["X"], b["Y"]] for b in points], curve["control_points"], program.name)
                self.assertEqual([b.get("R", 1.0) for b in points], curve["weights"], program.name)
                self.assertEqual(points[0]["P"], curve["degree"] + 1)
                self.assertEqual(len(blocks), len(curve["knots"]))
                for block, knot in zip(blocks, curve["knots"]):
                    self.assertAlmostEqual(block["K"], knot * scale, delta=1e-9, msg=program.name)

    def test_start_a_curve_where_the_tool_is(self):
        for path in CURVES.glob("*.json"):
            blocks = [dict(block) for block in words(PROGRAMS / (path.stem + ".ngc"))]
            first = next(i for i, block in enumerate(blocks) if "K" in block)
            approach = [block for block in blocks[:first] if "X" in block][-1]
            self.assertEqual((approach["X"], approach["Y"]), (blocks[first]["X"], blocks[first]["Y"]))

    def test_stay_inside_the_travel_of_the_default_table(self):
        for path in sorted(PROGRAMS.glob("*.ngc")):
            for block in words(path):
                for letter, value in block:
                    self.assertLessEqual(abs(value), TRAVEL_MM.get(letter, math.inf), path.name)

    def polygon_directions(self):
        """Of its legs, in degrees."""
        corners = [(b["X"], b["Y"]) for b in map(dict, words(PROGRAMS / "polygon.ngc")) if "X" in b]
        self.assertEqual(corners[0], corners[-1])
        return [math.degrees(math.atan2(b[1] - a[1], b[0] - a[0])) for a, b in zip(corners, corners[1:])]

    def test_polygon_has_the_published_corner_feedrates(self):
        # 12.5 m/s2 over a tick of 1 ms is a jump of 12.5 mm/s along its vector, 750 mm/min; the paper drops what is behind the point.
        directions = self.polygon_directions()
        turns = [math.radians(b - a) for a, b in zip(directions, directions[1:])]
        feedrates = [750.0 / abs(2.0 * math.sin(turn / 2.0)) for turn in turns]
        self.assertEqual([int(feedrate) for feedrate in feedrates], [674, 425, 530, 425, 674])

    def test_polygon_has_the_published_axial_feedrates_at_800(self):
        directions = self.polygon_directions()
        for direction in directions:
            self.assertAlmostEqual(direction / 11.25, round(direction / 11.25), delta=1e-6)
        self.assertAlmostEqual(max(800.0 * abs(math.cos(math.radians(d))) for d in directions), 784.628, delta=5e-4)
        self.assertAlmostEqual(max(800.0 * abs(math.sin(math.radians(d))) for d in directions), 665.176, delta=5e-4)

    def test_pocket_closes_every_arc(self):
        """Both radii of an arc agree to a nanometre, so that no control refuses it."""
        x = y = 0.0
        arcs = 0
        for block in map(dict, words(PROGRAMS / "pocket.ngc")):
            end = (block.get("X", x), block.get("Y", y))
            if block.get("G") == 3.0 and ("I" in block or "J" in block):
                centre = (x + block.get("I", 0.0), y + block.get("J", 0.0))
                self.assertAlmostEqual(math.dist((x, y), centre), math.dist(end, centre), delta=1e-6)
                arcs += 1
            if block.get("G") == 3.0 and "R" in block:
                self.assertLessEqual(math.dist((x, y), end), 2 * block["R"])
                arcs += 1
            x, y = end
        self.assertGreater(arcs, 40)


class Generator(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        spec = importlib.util.spec_from_file_location("make_programs", ROOT / "scripts" / "make_programs.py")
        cls.module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(cls.module)

    def test_writes_numbers_that_read_back_exactly(self):
        for value in (0.0, -0.0, 1.0, 100.0, -77.0061, 0.7071067811865476, 1e-9, 1e15):
            text = self.module.number(value)
            self.assertEqual(float(text), value)
            self.assertRegex(text, r"^-?\d+\.\d*$")
        self.assertEqual(self.module.number(-0.0), "0.")
        self.assertEqual(self.module.number(100), "100.")

    def test_scales_the_knots_of_linuxcnc_by_the_least_power_of_ten(self):
        curve = {"name": "circle", "degree": 1, "control_points": [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]],
                 "weights": [1.0, 1.0, 1.0], "knots": [0.0, 0.0, 0.15, 1.0, 1.0]}
        text = " ".join(self.module.linuxcnc(curve))
        self.assertEqual(re.findall(r"K(\S+)", text), ["0", "0", "15", "100", "100"])


if __name__ == "__main__":
    unittest.main()
