#!/usr/bin/env python3
"""The judges of ticks pass motion that is right and fail motion that is not: a made-up kerf runs a circle whose motion has a closed form."""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))
import check_programs  # noqa: E402
import tick_laws  # noqa: E402
from nurbs import Nurbs  # noqa: E402

CIRCLE = ROOT / "tests" / "programs" / "curves" / "circle.json"
MACHINE = """
[tick]
period_s = 0.001
[path]
max_velocity_mm_s = 100
max_acceleration_mm_s2 = 3000
max_jerk_mm_s3 = 55000
chord_tolerance_mm = 5e-4
"""
TS = 0.001


def quintic(x):
    """The shape and its first three derivatives and integral."""
    x = min(max(x, 0.0), 1.0)
    return (10 * x**3 - 15 * x**4 + 6 * x**5, 30 * x**2 * (1 - x) ** 2, 60 * x - 180 * x**2 + 120 * x**3,
            2.5 * x**4 - 3 * x**5 + x**6)


def motion(t, v, rise, cruise):
    """s, v, a, j of a quintic rise to v, a cruise and the rise mirrored."""
    if t > rise + cruise / 2:
        s, speed, a, j = motion(2 * rise + cruise - t, v, rise, cruise)
        return v * (rise + cruise) - s, speed, -a, j
    shape, slope, bend, integral = quintic(t / rise)
    s = v * rise * integral + v * max(0.0, t - rise)
    return s, v * shape, v * slope / rise, v * bend / rise**2


def circle_rows(v=40.0, duration_ticks=230):
    """A turn of the unit circle from rest to rest in whole ticks, after three ticks of approach at rest."""
    duration = duration_ticks * TS
    rise = duration - 2 * math.pi / v
    rows = [[line, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0] for line in (4, 5, 5)]
    for i in range(1, duration_ticks + 1):
        s, speed, a, j = motion(i * TS, v, rise, duration - 2 * rise)
        rows.append([6, s, speed, a, j, math.cos(s), math.sin(s), 0.0])
    return rows


def text(rows):
    lines = [check_programs.HEADER]
    for i, (line, s, v, a, j, x, y, z) in enumerate(rows):
        position = f"{x:.10f},{y:.10f},{z:.10f}"
        lines.append(f"{i * TS:.6f},{line},{s:.10f},{v:.9g},{a:.9g},{j:.9g},{position},{position}")
    return "\n".join(lines) + "\n"


class Judges(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="a trace ")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "machine.toml").write_text(MACHINE)

    def judged(self, trace, status=0):
        """What check_programs says of a kerf that writes this trace."""
        (self.folder / "made.csv").write_text(trace)
        kerf = self.folder / "kerf"
        kerf.write_text(f'#!/bin/sh\nwhile [ "$1" != --trace ]; do shift; done\ncp "{self.folder}/made.csv" "$2"\nexit {status}\n')
        os.chmod(kerf, 0o755)
        return subprocess.run(
            [sys.executable, HERE / "check_programs.py", "--kerf", kerf, "--machine", self.folder / "machine.toml",
             "--profile", "quintic", ROOT / "programs" / "circle.ngc", CIRCLE], capture_output=True, text=True, check=False)

    def fails(self, rows, *reasons):
        result = self.judged(text(rows))
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        for reason in reasons:
            self.assertIn(reason, result.stdout)

    def test_pass_a_turn_in_closed_form(self):
        result = self.judged(text(circle_rows()))
        self.assertEqual((result.returncode, result.stdout), (0, "circle.ngc quintic: good\n"), result.stderr)

    def test_fail_a_tick_two_nanometres_off_the_curve(self):
        rows = circle_rows()
        rows[100][5:7] = [c * (1 + 2e-9) for c in rows[100][5:7]]
        self.fails(rows, "on_curve: tick 98")

    def test_fail_a_tick_late_on_the_curve(self):
        rows = circle_rows()
        angle = rows[100][1] - 1e-6
        rows[100][5:7] = math.cos(angle), math.sin(angle)
        self.fails(rows, "length:")

    def test_fail_a_jerk_over_the_limit(self):
        rows = circle_rows()
        for row, push in zip(rows[50:], (1, 4, 6, 4, 1)):  # a quarter of a micrometre at the most
            row[1] += push * 4e-5
            row[5:7] = math.cos(row[1]), math.sin(row[1])
        self.fails(rows, "j ", "EXCEEDED", "plan:")

    def test_fail_a_plan_that_names_a_jerk_over_the_limit(self):
        rows = circle_rows()
        rows[60][4] = 55001.0
        self.fails(rows, "limits: tick 58: j = 55001")

    def test_fail_a_turn_too_fast_for_the_chord(self):
        rows = circle_rows(v=66.0, duration_ticks=180)
        self.fails(rows, "chord")

    def test_fail_an_end_before_the_end(self):
        self.fails(circle_rows()[:-1], "ends: the last tick is")

    def test_fail_a_start_in_motion(self):
        self.fails([[5, *row[1:]] if i < 60 else row for i, row in enumerate(circle_rows())], "no tick rests on the curve's first point")
        self.fails(circle_rows()[:2] + circle_rows()[60:], "rest")

    def test_fail_a_lost_tick(self):
        rows = circle_rows()
        lines = text(rows).splitlines()
        del lines[100]
        result = self.judged("\n".join(lines) + "\n")
        self.assertEqual(result.returncode, 1)
        self.assertIn("clock", result.stdout)

    def test_fail_a_kerf_that_fails(self):
        result = self.judged(text(circle_rows()), status=4)
        self.assertEqual(result.returncode, 1)
        self.assertIn("kerf ended with 4", result.stdout)

    def test_fail_another_header_and_a_trace_without_the_curve(self):
        self.assertEqual(self.judged(text(circle_rows()).replace("j_mm_s3", "jerk")).returncode, 1)
        self.assertEqual(self.judged(text(circle_rows()[:3])).returncode, 1)


class NurbsByDefinition(unittest.TestCase):
    def test_has_the_length_and_radius_of_the_circle(self):
        circle = Nurbs.load(CIRCLE)
        self.assertAlmostEqual(sum(circle.length(k / 64, (k + 1) / 64) for k in range(64)), 2 * math.pi, delta=1e-12)
        for k in range(101):
            self.assertAlmostEqual(math.hypot(*circle.evaluate(k / 100)[0]), 1.0, delta=1e-14)

    def test_has_the_derivative_that_differences_have(self):
        for name in ("butterfly", "wm", "trident7", "star"):
            curve = Nurbs.load(CIRCLE.with_name(name + ".json"))
            step = 1e-7 * (curve.last - curve.first)
            for k in range(1, 40):
                u = curve.first + (curve.last - curve.first) * (k + 0.37) / 41
                ahead, behind = curve.evaluate(u + step)[0], curve.evaluate(u - step)[0]
                for a, b, d in zip(ahead, behind, curve.evaluate(u)[1]):
                    self.assertAlmostEqual((a - b) / (2 * step), d, delta=1e-4 * max(1.0, abs(d)), msg=f"{name} at {u}")

    def test_finds_the_nearest_point(self):
        curve = Nurbs.load(CIRCLE.with_name("butterfly.json"))
        for k in range(1, 50):
            u = k / 50
            found, gap = curve.nearest(curve.evaluate(u)[0], u - 1e-4, 0.0)
            self.assertLess(abs(found - u), 1e-11)
            self.assertLess(gap, 1e-12)


class Limits(unittest.TestCase):
    def test_leave_out_what_the_file_leaves_out(self):
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write("[path]\nmax_velocity_mm_s = 3\n")
            file.flush()
            self.assertEqual(tick_laws.path_limits(file.name), [0.001, 3.0, math.inf, math.inf, math.inf])


class CurveData(unittest.TestCase):
    def test_names_a_source_and_is_a_clamped_curve(self):
        files = sorted(CIRCLE.parent.glob("*.json"))
        self.assertGreaterEqual(len(files), 8)
        for path in files:
            data = json.loads(path.read_text())
            order = data["degree"] + 1
            self.assertTrue(data["source"])
            self.assertEqual(len(data["knots"]), len(data["control_points"]) + order)
            self.assertEqual(data["knots"], sorted(data["knots"]))
            self.assertEqual(len(set(data["knots"][:order])), 1)
            self.assertEqual(len(set(data["knots"][-order:])), 1)


if __name__ == "__main__":
    unittest.main()
