#!/usr/bin/env python3
"""--start, --g54 and --units: where a program runs, whether it fits, and how its feeds are written."""
import csv
import json
import os
import pathlib

from command_line import Case, SOURCE, main

PART = "G21 G90 G17 G61\nG0 Z30\nG0 X100 Y50\nG1 Z-2 F600\nX120\nG0 Z30\nM2\n"


class Start(Case):
    def report(self, *words, **more):
        return json.loads(self.kerf("dry-run", "--json", *words, **more).stdout)

    def first_row(self, *words):
        self.kerf("dry-run", "-q", *words, "--trace", self.path("t.csv"))
        with open(self.path("t.csv"), encoding="utf-8") as file:
            row = next(csv.DictReader(file))
        return [float(row[axis + "_mm"]) for axis in "xyz"]

    def test_is_machine_zero_or_where_it_is_said_to_be(self):
        part = self.path("part.ngc", PART)
        self.assertEqual(self.first_row(part), [0, 0, 0])
        self.assertEqual(self.first_row(part, "--start", "-3,4.5,10"), [-3, 4.5, 10])
        self.assertEqual(self.report(part, "--start", "-3,4.5,10")["extents"]["min_mm"], {"x": -3, "y": 4.5, "z": -2})

    def test_at_the_first_moves_leaves_no_approach(self):
        part = self.path("part.ngc", PART)
        self.assertEqual(self.first_row(part, "--start", "first-move"), [100, 50, 30])
        report = self.report(part, "--start", "first-move")
        self.assertEqual(report["approach"]["time_s"], 0)
        self.assertEqual(report["path_length_mm"], 32 + 20 + 32)
        self.assertEqual(report["extents"]["min_mm"], {"x": 100, "y": 50, "z": -2})

    def test_at_the_first_moves_is_the_first_of_a_block_with_several(self):
        for first, place in (("G0 X10 Y20\nG81 X10 Y20 Z-5 R2 F100", [10, 20, 2]), ("G28 Z50\nG0 X10 Y20\nG1 Z-1 F100", [10, 20, 50])):
            self.assertEqual(self.first_row(self.path("several.ngc", "G21 G90\n" + first + "\nM2\n"), "--start", "first-move"), place)

    def test_at_the_first_moves_is_the_end_of_a_first_cut(self):
        self.assertEqual(self.first_row(self.path("cut.ngc", "G21 G90 F600\nG1 X7 Y3\nG1 X9 Z4\nM2\n"), "--start", "first-move"), [7, 3, 0])

    def test_starts_where_a_rapid_to_machine_zero_leads(self):
        part = self.path("zero.ngc", "G21 G90 G61\nG0 X0 Y0 Z0\nG4 P0.01\nG1 X10 F1000\nG1 Y10\nM2\n")
        self.assertEqual(self.first_row(part, "--start", "first-move"), [0, 0, 0])

    def test_at_the_first_moves_counts_the_work_offset(self):
        part = self.path("part.ngc", PART)
        self.assertEqual(self.first_row(part, "--start", "first-move", "--g54", "10,20,-5"), [110, 70, 25])

    def test_at_relative_first_moves_is_refused(self):
        part = self.path("relative.ngc", "G21 G91 F600\nG0 X5\nG1 X5\nM2\n")
        for command in ("dry-run", "check"):
            self.assertIn("(G91 or G92)", self.kerf(command, part, "--start", "first-move", status=1).stderr)

    def test_at_a_first_cut_along_a_curve_is_refused(self):
        for cut in ("G2 X10 Y0 I5", "G2 X10 Y0 R6", "G5 X10 Y0 I1 J1 P-1 Q1"):
            part = self.path("curve.ngc", f"G21 G90 F300\n{cut}\nM2\n")
            self.assertIn("its first move is a curve", self.kerf("dry-run", part, "--start", "first-move", status=1).stderr)
        lifted = self.path("lifted.ngc", "G21 G90 F300\nG0 Z5\nG2 X10 Y0 I5\nM2\n")
        self.assertEqual(self.first_row(lifted, "--start", "first-move"), [0, 0, 5])

    def test_at_the_first_moves_of_a_loop_that_never_cuts_ends(self):
        part = self.path("loop.ngc", "G21 G90 G61\no1 while [1 EQ 1]\nG0 X1\nG0 X0\no1 endwhile\nM2\n")
        self.assertIn("E1006", self.kerf("check", part, "--start", "first-move", "--max-moves", "1000", status=1).stderr)

    def test_is_the_same_for_check_and_explain(self):
        part = self.path("part.ngc", PART)
        dry = self.report(part, "--start", "first-move")
        self.assertEqual(json.loads(self.kerf("check", "--json", part, "--start", "first-move").stdout)["cycle_time_s"], dry["cycle_time_s"])
        block = json.loads(self.kerf("explain", "--json", part, "--line", "2", "--start", "1,2,3").stdout)["block"]
        self.assertEqual(block["position_mm"], {"x": 1, "y": 2, "z": 3})

    def test_that_is_no_place_is_wrong_use(self):
        part = self.path("part.ngc", PART)
        for words in (("--start", "1,2"), ("--start", "home"), ("--g54", "first-move"), ("--g54", "1;2;3"), ("--start", "nan,0,0")):
            self.kerf("dry-run", part, *words, status=2)

    def test_names_the_approach_apart(self):
        part = self.path("part.ngc", PART)
        report = self.report(part)
        alone = self.report(self.path("approach.ngc", "G21 G90 G17 G61\nG0 Z30\nG0 X100 Y50\nM2\n"))
        # Both rapids end at rest, so they take as long without what follows.
        self.assertAlmostEqual(report["approach"]["time_s"], alone["cycle_time_s"], delta=0.0015)
        self.assertAlmostEqual(report["approach"]["time_s"] + report["approach"]["cycle_time_without_s"], report["cycle_time_s"], places=9)
        self.assertEqual(alone["approach"]["time_s"], 0)  # nothing is cut
        self.assertRegex(self.kerf("dry-run", part).stdout, r"\n  approach        0:00:0\d\.\d+ of rapids before the first cut, 0:00:0\d\.\d+ without\n")


class Fit(Case):
    def test_extents_are_named(self):
        part = self.path("part.ngc", PART)
        text = self.kerf("dry-run", part, "--g54", "10,20,-5").stdout
        for line in ("  extents         x 0.000 to 130.000, y 0.000 to 70.000, z -7.000 to 25.000 mm   all motion, on the machine\n"
                     "                  x -10.000 to 120.000, y -20.000 to 50.000, z -2.000 to 30.000 mm   all motion, in G54\n",
                     "  cutting         x 110.000 to 130.000, y 70.000 to 70.000, z -7.000 to 25.000 mm   on the machine\n"
                     "                  x 100.000 to 120.000, y 50.000 to 50.000, z -2.000 to 30.000 mm   in G54\n"):
            self.assertIn(line, text)
        boxes = json.loads(self.kerf("check", part, "--g54", "10,20,-5", "--json").stdout)["path_boxes"]
        self.assertEqual(boxes["machine"]["cutting"], {"min_mm": {"x": 110, "y": 70, "z": -7}, "max_mm": {"x": 130, "y": 70, "z": 25}})
        self.assertEqual(boxes["work"]["systems"], ["G54"])
        self.assertEqual(boxes["work"]["cutting"]["max_mm"], {"x": 120, "y": 50, "z": 30})
        self.assertIn("z -2.000 to 30.000 mm   all motion, on the machine and in G54\n", self.kerf("dry-run", part).stdout)

    def test_what_does_not_fit_says_between_which_offsets_it_would(self):
        part = self.path("part.ngc", PART)
        for command in ("dry-run", "check"):
            done = self.kerf(command, part, "--g54", "395,0,0", status=4)
            self.assertIn("part.ngc: does not fit\n", done.stdout)
            self.assertIn("  would fit       G54 X between -600.000 and 380.000\n", done.stdout)
            fit = json.loads(self.kerf(command, part, "--g54", "395,0,0", "--json", status=4).stdout)["fit"]
            self.assertFalse(fit["fits"])
            self.assertEqual(fit["axes"]["x"], {"travel_mm": [-500, 500], "over_mm": 15, "fixed_over_mm": 0})
            self.assertEqual(fit["work_offsets"][0]["axes"]["x"], {"origin_mm": 395, "min_mm": -600, "max_mm": 380, "fits_somewhere": True})

    def test_of_travel_with_one_bound_that_one_is_told(self):
        part = self.path("part.ngc", "G21 G90\nG1 X50 F600\nX-50\nM2\n")
        for bound, told in (("max_mm = 20", "over by 30.000 mm; travel up to 20 mm\n"), ("min_mm = -20", "over by 30.000 mm; travel from -20 mm\n")):
            machine = self.path("half.toml", f"[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\n[axes.x]\n{bound}\n")
            self.assertIn(told, self.kerf("check", part, "--machine", machine, status=4).stdout)

    def test_what_starts_at_its_first_moves_does_not_fit_for_their_offset_alone(self):
        part = self.path("part.ngc", "G21 G90\nG0 X10\nG1 X50 F3000\nM2\n")
        done = self.kerf("check", part, "--g54", "600,0,0", "--start", "first-move", status=4)
        self.assertIn("would fit       G54 X between -510.000 and 450.000", done.stdout + done.stderr)
        for x in ("450", "-510"):
            self.kerf("check", part, f"--g54={x},0,0", "--start", "first-move")

    def test_what_another_axis_leaves_its_travel_by_does_not_fit(self):
        machine = self.path("turning.toml", "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\n[axes.a]\nmin_deg = -720\nmax_deg = 720\nmax_velocity_deg_s = 100\nmax_acceleration_deg_s2 = 1000\nmax_jerk_deg_s3 = 10000\n")
        for program, text in (("G1 A800 F600", "  other axes      a goes 80 deg beyond its upper limit of 720 deg\n"),
                              ("G1 X600 A-721 F600", "  other axes      a goes 1 deg beyond its lower limit of -720 deg\n")):
            part = self.path("turn.ngc", f"G21 G90\n{program}\nM2\n")
            done = self.kerf("check", part, "--machine", machine, status=4)
            self.assertIn("turn.ngc: does not fit\n", done.stdout)
            self.assertIn(text, done.stdout)
            self.assertNotIn("would fit", done.stdout)
            self.assertFalse(json.loads(self.kerf("check", part, "--machine", machine, "--json", status=4).stdout)["fit"]["fits"])

    def test_where_x_y_and_z_would_fit_is_told_beside_another_axis_that_does_not(self):
        machine = self.path("turning.toml", "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\n"
                            "[axes.x]\nmin_mm = 0\nmax_mm = 300\n"
                            "[axes.a]\nmin_deg = -720\nmax_deg = 720\nmax_velocity_deg_s = 100\nmax_acceleration_deg_s2 = 1000\nmax_jerk_deg_s3 = 10000\n")
        part = self.path("turn.ngc", "G21 G90\nG1 X400 A800 F600\nM2\n")
        self.assertIn("  x, y, z fit with G54 X between -400.000 and -100.000\n", self.kerf("check", part, "--machine", machine, status=4).stdout)

    def test_is_true_at_both_ends_of_the_range_and_not_beyond(self):
        part = self.path("part.ngc", PART)
        for x, status in ((-600, 0), (-600.001, 4), (380, 0), (380.001, 4)):
            done = self.kerf("check", part, "--g54", f"{x},0,0", "--json", status=status)
            self.assertEqual(json.loads(done.stdout)["fit"]["fits"], status == 0)


class Units(Case):
    PATH = "path          250   100 %           2500   100 %          50000   100 %"

    def summary(self, *words, program="G21 G90 G61\nG0 X100\nG1 X200 F600\nM2\n"):
        return self.kerf("dry-run", self.path("part.ngc", program), *words).stdout

    def test_are_those_of_the_program_unless_told_otherwise(self):
        inch = "G20 G90 G61\nG0 X4\nG1 X5 F30\nM2\n"
        for unit, words, program in (("mm/min", (), None), ("inch/min", (), inch), ("inch/min", ("--units", "inch/min"), None),
                                     ("mm/min", ("--units", "mm/min"), inch)):
            text = self.summary(*words, **({"program": program} if program else {}))
            self.assertIn(f"jerk mm/s3   velocity {unit}\n", text)
            value = {"mm/min": "15000", "inch/min": "590.551"}[unit]  # 250 mm/s
            self.assertRegex(text, rf"  {self.PATH} +{value}\n")
        self.assertIn("jerk mm/s3\n", self.summary("--units", "mm/s"))

    def test_are_in_the_answers_about_speed_and_lines(self):
        self.assertRegex(self.summary("--explain-speed=@5", "--units", "inch/min"), r"line 3, 10 mm/s \(23\.622 inch/min\), limited by")
        part = self.path("part.ngc")
        self.assertIn("feed            10 mm/s\n", self.kerf("explain", part, "--line", "4", "--units", "mm/s").stdout)
        self.assertIn("feed            600 mm/min\n", self.kerf("explain", part, "--line", "4").stdout)

    def test_leave_json_as_it_is(self):
        part = self.path("part.ngc", "G20 G90 G61\nG1 X5 F30\nM2\n")
        reports = [json.loads(self.kerf("dry-run", "--json", part, *words).stdout) for words in ((), ("--units", "mm/min"))]
        for report in reports:
            report.pop("elapsed")
        self.assertEqual(*reports)
        self.assertAlmostEqual(reports[0]["max"]["path"]["v_mm_s"], 30 * 25.4 / 60, places=6)

    def test_are_in_the_plot(self):
        self.summary("--plot", self.path("p.svg"))
        svg = pathlib.Path(self.path("p.svg")).read_text(encoding="utf-8")
        self.assertIn(">v, mm/s; at the right mm/min<", svg)
        self.assertIn(">mm/min<", svg)
        self.summary("--plot", self.path("p.svg"), "--units", "mm/s")
        self.assertNotIn("min<", pathlib.Path(self.path("p.svg")).read_text(encoding="utf-8"))


if __name__ == "__main__":
    main()
