#!/usr/bin/env python3
"""What stands around the simulated table, in a run by the clock: its surface, its inputs, its home switches. TEST.py KERF SOURCE_DIR [NAME...]"""
import csv
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import Case, main  # noqa: E402

PATH = "[path]\nmax_velocity_mm_s = 250\nmax_acceleration_mm_s2 = 2500\nmax_jerk_mm_s3 = 50000\n"
SURFACE = PATH + "[probe]\nheight_map = 'map.txt'\nlatches = true\n[simulation]\ndigital = [3]\n"
HEIGHTS_MM = ((-2.0, -1.5, -1.8), (-1.3, -1.7, -1.2), (-1.6, -1.1, -1.9))
FIRST_MM, SPACING_MM = -10.0, 15.0  # of the map, in X and Y
STEEPEST = 0.8 / SPACING_MM
AT_REST_MM = 0.002  # the table itself is so near its setpoint in X and Y where it touches: two steps of its encoders
# Touches four places, then goes there: 1 mm lower where input 3 is high.
GRID = """G21 G61 G90 F3000
#1 = 0
o1 while [#1 LT 4]
G0 Z0
X[10 * [#1 MOD 2]] Y[10 * FIX[#1 / 2]]
G38.2 Z-5
#[100 + #1] = #5063
G0 Z0
#1 = [#1 + 1]
o1 endwhile
M66 P3 L0
G64 P0.05
#1 = 0
o2 while [#1 LT 4]
G1 X[10 * [#1 MOD 2]] Y[10 * FIX[#1 / 2]] Z[#[100 + #1] - #5399]
G4 P0.01
#1 = [#1 + 1]
o2 endwhile
M2
"""
SWITCHES = PATH + """[axes.x]
home_switch_mm = 0
home_mm = 2
home_search_mm_s = -50
home_latch_mm_s = 2
home_back_off_mm = 5
[axes.y]
home_switch_mm = 100
home_search_mm_s = 50
home_latch_mm_s = 4
home_order = 2
[simulation.x]
home_min_mm = -30
home_max_mm = -5
[simulation.y]
home_min_mm = 7
home_max_mm = 30
"""
AXES = ("x_mm", "y_mm", "z_mm")


def height_mm(x, y):
    """Bilinear."""
    i, p = divmod((x - FIRST_MM) / SPACING_MM, 1)
    j, q = divmod((y - FIRST_MM) / SPACING_MM, 1)
    a, b = (HEIGHTS_MM[int(j) + k][int(i)] * (1 - p) + HEIGHTS_MM[int(j) + k][int(i) + 1] * p for k in (0, 1))
    return a * (1 - q) + b * q


class Table(Case):
    def rows(self, trace):
        with open(trace, encoding="utf-8") as file:
            return list(csv.DictReader(row for row in file if not row.startswith("#")))

    def test_a_grid_warped_by_what_was_touched_is_the_same_in_a_run_as_in_a_dry_run(self):
        machine = self.path("surface.toml", SURFACE)
        places = [(FIRST_MM + SPACING_MM * i, FIRST_MM + SPACING_MM * j, HEIGHTS_MM[j][i]) for i in range(3) for j in range(3)]
        self.path("map.txt", "".join("%g %g %g\n" % place for place in places))
        program = self.path("grid.ngc", GRID)
        dry = self.path("dry-run.csv")
        self.kerf("dry-run", "-q", program, "--machine", machine, "--trace", dry)
        for _ in range(3):
            run = json.loads(self.kerf("run", "-q", "--json", program, "--machine", machine, "--trace", self.path("run.csv")).stdout)
            if run["starved_ticks"] == 0:
                break
        else:
            self.skipTest("planning is too slow here for a run in real time")
        self.assertEqual(pathlib.Path(dry).read_text(), pathlib.Path(self.path("run.csv")).read_text())
        deepest = [row for row in self.rows(dry) if row["line"] == "16"]  # of the dwells
        reached = sorted({tuple(float(row[axis]) for axis in AXES) for row in deepest})
        self.assertEqual([place[:2] for place in reached], [(0.0, 0.0), (0.0, 10.0), (10.0, 0.0), (10.0, 10.0)])
        for x, y, z in reached:
            self.assertAlmostEqual(z, height_mm(x, y) - 1.0, delta=STEEPEST * AT_REST_MM)

    def test_a_probe_is_no_path_mode_of_the_program(self):
        machine = self.path("table.toml", PATH + "[probe]\nz_max_mm = -1\n")
        program = self.path("touch.ngc", "G21 G90 F600\nG38.2 Z-2\nG1 X1\nM2\n")
        modes = json.loads(self.kerf("dry-run", program, "--machine", machine, "--json").stdout)["path_modes"]
        self.assertEqual([(mode["mode"], mode["by"]) for mode in modes], [("G64", "machine")])

    def test_home_is_found_at_the_tables_switches_and_the_program_runs_from_there(self):
        machine = self.path("switches.toml", SWITCHES)
        program = self.path("way.ngc", "G21 G90 G61 F3000\nG1 X5\nY95\nM2\n")
        self.assertIn("the axes are not homed", self.kerf("run", program, "--machine", machine, status=4).stderr)
        self.kerf("run", "-q", program, "--machine", machine, "--home", "--trace", self.path("t.csv"))
        places = [tuple(float(row[axis]) for axis in AXES) for row in self.rows(self.path("t.csv"))]
        jumps = [(a, b) for a, b in zip(places, places[1:]) if max(abs(p - q) for p, q in zip(a, b)) > 1.0]
        self.assertEqual(len(jumps), 2)
        # The switch of X closes at -5 and is at 0, that of Y at 7 and at 100; a tick of 1 ms at the latch's feedrate, and an encoder's step, are how exact that is.
        for (before, after), axis, shift, exact in zip(jumps, (0, 1), (5.0, 93.0), (0.003, 0.005)):
            self.assertAlmostEqual(after[axis] - before[axis], shift, delta=exact)
            self.assertEqual([p for k, p in enumerate(before) if k != axis], [p for k, p in enumerate(after) if k != axis])
        self.assertEqual(places[-1], (5.0, 95.0, 0.0))
        # X went to its place of rest before Y looked for its switch.
        self.assertEqual(jumps[1][0][0], 2.0)

    def test_a_run_that_looked_for_home_is_repeated_from_its_record(self):
        machine = self.path("switches.toml", SWITCHES)
        program = self.path("way.ngc", "G21 G90 G61 F3000\nG1 X5\nY95\nM2\n")
        self.kerf("run", "-q", program, "--machine", machine, "--home", "--record", self.path("first.rec"))
        for command in ("run", "dry-run"):  # by the record alone
            self.kerf(command, "-q", program, "--machine", machine, "--replay", self.path("first.rec"), "--record", self.path("again.rec"))
            self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), pathlib.Path(self.path("first.rec")).read_bytes())


if __name__ == "__main__":
    main()
