#!/usr/bin/env python3
"""What `kerf dry-run` and `kerf run` leave: summary, trace and plot."""
import csv
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree

from command_line import Case, KERF, SOURCE, SQUARE, TOO_FAR, WRONG, main


class DryRun(Case):
    def test_prints_a_summary_and_nothing_on_standard_error(self):
        done = self.kerf("dry-run", self.path("square.ngc", SQUARE))
        self.assertIn("square.ngc: done", done.stdout)
        self.assertIn("path            80.000 mm in 4 blocks", done.stdout)
        self.assertIn("extents         x 0.000 to 20.000, y 0.000 to 20.000, z 0.000 to 0.000 mm", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_takes_a_program_from_standard_input(self):
        from_file = self.kerf("dry-run", self.path("square.ngc", SQUARE)).stdout
        from_pipe = self.kerf("dry-run", "-", stdin=SQUARE).stdout
        self.assertEqual(from_pipe.split("\n", 1)[1], from_file.split("\n", 1)[1])
        self.assertTrue(from_pipe.startswith("<stdin>: done"))

    def test_takes_standard_input_where_somebody_left_off_reading_a_file(self):
        path = self.path("two.txt", "not G-code\n" + SQUARE)
        with open(path) as file:
            os.lseek(file.fileno(), len("not G-code\n"), os.SEEK_SET)
            done = subprocess.run([KERF, "dry-run", "-"], stdin=file, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_picture_on_standard_output_stands_alone(self):
        done = self.kerf("dry-run", "--plot", "-", self.path("square.ngc", SQUARE))
        self.assertTrue(done.stdout.startswith("<?xml") or done.stdout.startswith("<svg"), done.stdout[:40])
        self.assertTrue(done.stdout.endswith("</svg>\n"), done.stdout[-40:])
        self.assertIn("square.ngc: done", done.stderr)
        for other in (("--json",), ("--trace", "-")):
            self.kerf("dry-run", "--plot", "-", *other, self.path("square.ngc", SQUARE), status=2)

    def test_of_several_files_reports_each_and_returns_the_first_failure(self):
        good, bad = self.path("good.ngc", SQUARE), self.path("bad.ngc", WRONG)
        done = self.kerf("dry-run", good, bad, good, self.path("far.ngc", TOO_FAR), status=1)
        self.assertEqual(done.stdout.count("good.ngc: done"), 2)

    def test_of_an_empty_program_is_an_error(self):
        for text in ("", "\n", "(nothing)\n"):
            with self.subTest(text=text):
                self.assertIn("<stdin>:1:1: error: ", self.kerf("dry-run", "-", stdin=text, status=1).stderr)

    def test_of_a_program_without_motion_is_done(self):
        for text in ("M30\n", "G21", "G4 P0.5\n"):
            with self.subTest(text=text):
                done = self.kerf("dry-run", "-", "--json", stdin=text)
                self.assertEqual(json.loads(done.stdout)["path_length_mm"], 0)

    def test_quiet_prints_nothing(self):
        done = self.kerf("dry-run", "--quiet", self.path("square.ngc", SQUARE))
        self.assertEqual(done.stdout + done.stderr, "")

    def test_block_delete_leaves_blocks_out(self):
        path = self.path("slash.ngc", "G21 G90 F1000\nG1 X10\n/G1 X20\nM30\n")
        length = lambda *more: json.loads(self.kerf("dry-run", "--json", path, *more).stdout)["path_length_mm"]
        self.assertAlmostEqual(length(), 20.0)
        self.assertAlmostEqual(length("--block-delete"), 10.0)


class Trace(Case):
    HEADER = "t_s,line,s_mm,v_mm_s,a_mm_s2,j_mm_s3,x_mm,y_mm,z_mm,actual_x_mm,actual_y_mm,actual_z_mm,u,chord_error_mm"

    def trace(self, *words):
        path = self.path("trace.csv")
        done = self.kerf("dry-run", *words, "--json", "--trace", path)
        return json.loads(done.stdout), pathlib.Path(path).read_text()

    def test_has_a_row_for_each_tick_from_the_start_to_the_end(self):
        report, text = self.trace(self.path("square.ngc", SQUARE))
        lines = text.splitlines()
        self.assertEqual(lines[0], self.HEADER)
        rows = list(csv.DictReader(lines))
        self.assertEqual(len(rows), report["ticks"] + 1)
        for number, row in enumerate(rows):
            self.assertEqual(row["t_s"], f"{number * 1000 // 1000000}.{number * 1000 % 1000000:06}")
        for key in ("x_mm", "y_mm", "z_mm", "v_mm_s"):
            self.assertEqual(float(rows[0][key]), 0)
            self.assertEqual(float(rows[-1][key]), 0)
        self.assertEqual(rows[-1]["s_mm"], "80.0000000000")
        self.assertEqual({row["line"] for row in rows}, {"3", "4", "5", "6"} | {rows[-1]["line"]})
        corners = {(row["x_mm"], row["y_mm"]) for row in rows}
        for corner in (("20.0000000000", "0.0000000000"), ("20.0000000000", "20.0000000000")):
            self.assertIn(corner, corners)

    def test_is_the_same_to_the_last_bit_in_every_run(self):
        program = os.path.join(SOURCE, "programs/butterfly.ngc")
        first, second = self.trace(program), self.trace(program)
        self.assertEqual(first[1], second[1])
        for report, _ in (first, second):
            report.pop("elapsed")
        self.assertEqual(first[0], second[0])

    def test_is_the_same_in_the_second_run_of_one_process(self):
        program = os.path.join(SOURCE, "programs/trident7.ngc")
        lines = self.kerf("dry-run", "--json", program, program).stdout.splitlines()
        first, second = (json.loads(line) for line in lines)
        first.pop("elapsed"), second.pop("elapsed")
        self.assertEqual(first, second)

    def test_is_the_same_by_the_clock(self):
        square = self.path("square.ngc", SQUARE)
        self.kerf("dry-run", square, "--trace", self.path("dry.csv"))
        self.kerf("run", square, "--trace", self.path("run.csv"))
        self.assertEqual(pathlib.Path(self.path("dry.csv")).read_bytes(), pathlib.Path(self.path("run.csv")).read_bytes())

    def test_does_not_depend_on_the_locale(self):
        locales = self.path("locales")
        os.mkdir(locales)
        name = os.path.join(locales, "de_DE.utf8")
        made = shutil.which("localedef") and subprocess.run(
            ["localedef", "-i", "de_DE", "-f", "UTF-8", name], capture_output=True).returncode == 0
        if not made:
            self.skipTest("no data for the locale de_DE")
        square = self.path("square.ngc", SQUARE)
        plain = self.kerf("dry-run", square, "--trace", self.path("plain.csv"), "--plot", self.path("plain.svg"))
        german = self.kerf("dry-run", square, "--trace", self.path("german.csv"), "--plot", self.path("german.svg"),
                           env={**os.environ, "LOCPATH": locales, "LC_ALL": "de_DE.utf8", "LANG": "de_DE.utf8"})
        self.assertEqual(plain.stdout, german.stdout)
        for kind in ("csv", "svg"):
            self.assertEqual(pathlib.Path(self.path("plain." + kind)).read_bytes(),
                             pathlib.Path(self.path("german." + kind)).read_bytes())

    def test_goes_to_standard_output_alone(self):
        done = self.kerf("dry-run", self.path("square.ngc", SQUARE), "--trace", "-")
        lines = done.stdout.splitlines()
        self.assertEqual(lines[0], self.HEADER)
        self.assertTrue(all(line.count(",") == 13 for line in lines))
        self.assertIn("square.ngc: done", done.stderr)


    def test_has_the_parameter_of_the_curve_and_the_chord_error(self):
        machine = os.path.join(SOURCE, "programs/machines/sigmoid-butterfly.toml")
        report, text = self.trace(os.path.join(SOURCE, "programs/butterfly.ngc"), "--machine", machine)
        rows = list(csv.DictReader(text.splitlines()))
        sys.path.insert(0, os.path.join(SOURCE, "tests", "tools"))
        from nurbs import Nurbs
        curve = Nurbs.load(os.path.join(SOURCE, "tests/programs/curves/butterfly.json"))
        on_curve = [row for row in rows if row["u"]]
        parameters = [float(row["u"]) for row in on_curve]
        self.assertEqual(parameters, sorted(parameters))
        self.assertEqual(parameters[-1], 1.0)
        self.assertGreater(len(rows), len(on_curve))  # the approach is on no curve
        for row in on_curve[::50]:
            point, _ = curve.evaluate(float(row["u"]))
            self.assertLess(math.dist(point, [float(row[axis + "_mm"]) for axis in "xyz"]), 1e-7)
        self.assertAlmostEqual(max(float(row["chord_error_mm"]) for row in rows), report["chord_error_mm"], delta=1e-10)


class Check(Case):
    CORNERS = "G21 G90 F3000\n{}\nG1 X20\nY20\nG2 X10 Y10 I-10\nM62 P1\nG1 X0\nG0 Y5\nG4 P0.1\nM3 S100\nG1 X5 Y1\nY0\nX0\nM63 P1\nM30\n"

    def agrees_with_a_run(self, path, *words):
        checked, ran = (json.loads(self.kerf(command, path, "--json", *words).stdout) for command in ("check", "dry-run"))
        for key in ("ticks", "cycle_time_s", "path_length_mm", "blocks", "deviation"):
            self.assertEqual(checked[key], ran[key], (path, words, key))
        return checked

    def test_foretells_a_run_to_the_tick_in_every_path_mode(self):
        checked = {}
        for mode in ("G61", "G61.1", "G64", "G64 P0.05", "G64 P0 Q0.1", "G64 P0.1 Q0"):
            for profile in ("time-optimal", "s-curve"):
                with self.subTest(mode=mode, profile=profile):
                    path = self.path(mode + ".ngc", self.CORNERS.format(mode))
                    checked[mode, profile] = self.agrees_with_a_run(path, "--profile", profile)
        for profile in ("time-optimal", "s-curve"):
            stops, blends = (checked[mode, profile] for mode in ("G61.1", "G64 P0.05"))
            self.assertLess(blends["cycle_time_s"], stops["cycle_time_s"])
            self.assertLess(blends["path_length_mm"], stops["path_length_mm"])

    def test_foretells_a_run_of_merged_lines_to_the_tick(self):
        lines = [f"X{30 + 30 * math.sin(0.01 * i):.3f} Y{30 - 30 * math.cos(0.01 * i):.3f}" for i in range(1500)]
        program = "G21 G90 G64 P0.01\nG0 X30 Y0\nG1 F6000\n" + "\n".join(lines) + "\nM30\n"
        for window in ("1000", "20"):
            checked = self.agrees_with_a_run(self.path("merged.ngc", program), "--window", window)
            self.assertLess(checked["blocks"], 500)


class Plot(Case):
    def test_is_xml_of_bounded_size(self):
        path = self.path("plot.svg")
        self.kerf("dry-run", os.path.join(SOURCE, "programs/butterfly.ngc"), "--plot", path)
        root = xml.etree.ElementTree.parse(path).getroot()
        self.assertTrue(root.tag.endswith("svg"))
        texts = [element.text or "" for element in root.iter() if element.tag.endswith("text")]
        for words in ("v, mm/s; at the right mm/min", "chord error, \u00b5m", "mm/s", "mm/min", "rapid", "time, s"):
            self.assertIn(words, texts)
        self.assertLess(os.path.getsize(path), 1_000_000)

    def test_shows_the_scan_of_the_first_curve_with_its_breaking_points(self):
        path = self.path("plot.svg")
        words = lambda: "".join(xml.etree.ElementTree.parse(path).getroot().itertext())
        machine = os.path.join(SOURCE, "programs/machines/sigmoid-butterfly.toml")
        self.kerf("dry-run", os.path.join(SOURCE, "programs/butterfly.ngc"), "--machine", machine, "--plot", path)
        self.assertIn("v over u, mm/s, of the curve in line 6", words())
        self.assertIn("scanned, 39 breaking points, 38 blocks", words())  # docs/math.md, 6.1
        self.kerf("dry-run", self.path("square.ngc", SQUARE), "--plot", path)
        self.assertNotIn("breaking points", words())


if __name__ == "__main__":
    main()
