#!/usr/bin/env python3
"""The executable `kerf` as its users meet it: command_line_test.py KERF SOURCE_DIR

Exit statuses, streams, signals and files; the figures themselves are other tests' business.
"""
import csv
import json
import os
import pathlib
import pty
import select
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

KERF = SOURCE = None

SQUARE = "G21 G90 G17\nF3000\nG1 X20\nG1 Y20\nG1 X0\nG1 Y0\nM30\n"
LONG = "G21 G90\nF600\n" + "G1 X200\nG1 X0\n" * 50 + "M30\n"  # 2000 s
WRONG = "G21 G90\nG1 X1 F100\nG1 Xq\nG1 X3\nG77\n"
TOO_FAR = "G21 G90\nG1 X10 F1000\nG1 X1000\n"


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="kerf-test-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def path(self, name, text=None):
        path = self.folder / name
        if text is not None:
            path.write_text(text)
        return str(path)

    def kerf(self, *words, status=0, stdin=None, env=None, text=True):
        done = subprocess.run([KERF, *words], input=stdin, capture_output=True, text=text, env=env, timeout=120)
        self.assertEqual(done.returncode, status, f"{words}\n{done.stdout}\n{done.stderr}")
        return done


class Explain(Case):
    def test_outputs_at_motion_take_no_time_and_a_tool_of_no_length_is_in_force(self):
        program = self.path("out.ngc", "G1 X10 F600\nM62 P1\nG1 X20\nT2 M6\nG43 H2\nG0 X0\nM2\n")
        trace = self.path("out.csv")
        self.kerf("dry-run", program, "--trace", trace, "-q")
        with open(trace) as file:
            rapid = [float(row["t_s"]) for row in csv.DictReader(file) if int(row["line"]) == 6]
        told = json.loads(self.kerf("explain", program, "--line", "6", "--json").stdout)["block"]
        self.assertAlmostEqual(told["begin_s"], rapid[0], delta=0.0011)
        self.assertIn("G43", told["codes"])

    def test_finds_the_time_that_the_trace_of_a_run_has(self):
        for name, step in (("pocket.ngc", 7), ("raster.ngc", 700)):
            self.compare_with_trace(str(pathlib.Path(SOURCE) / "programs" / name), step)

    def test_finds_the_time_of_moves_that_compensation_holds_back(self):
        program = self.path("held.ngc", "G21 G90 F600\nG0 X-20 Y-20\nG41.1 D4 G1 X0 Y0\nY30\nX30\nG2 X40 Y20 J-10\n"
                                        "(beside)\nG1 Y0\nG40 X60 Y-20\nX80\nM2\n")
        self.compare_with_trace(program, 1)
        self.assertEqual(self.explained(program, 7)["begin_s"], self.explained(program, 8)["begin_s"])
        for line, code in ((3, "G40"), (4, "G41.1"), (10, "G40")):
            self.assertIn(code, self.explained(program, line)["codes"])

    def test_shows_what_shapes_a_fanuc_program(self):
        program = self.path("shaped.nc", "G0 X1\nG51.1 X0\nG51 X0 Y0 P2.\nG68 X0 Y0 R90\nG0 X2\nG69\nG50\nG50.1\nG0 X3\nM30\n")
        shaped = self.explained(program, 5, "--dialect", "fanuc")["codes"]
        for code in ("G51.1", "G51", "G68"):
            self.assertIn(code, shaped)
        plain = self.explained(program, 9, "--dialect", "fanuc")["codes"]
        for code in ("G51.1", "G51", "G68"):
            self.assertNotIn(code, plain)

    def compare_with_trace(self, program, step):
        trace = self.path("t.csv")
        self.kerf("dry-run", program, "--trace", trace, "-q")
        with open(trace) as file:
            rows = [(float(row["t_s"]), int(row["line"])) for row in csv.DictReader(file)]
        lines = sorted({line for _, line in rows})
        for line in lines[2:-1:step]:
            with self.subTest(program=program, line=line):
                block = json.loads(self.kerf("explain", program, "--line", str(line), "--json").stdout)["block"]
                times = [t for t, at in rows if at == line]
                # A tick belongs to the phase that holds its instant.
                self.assertLess(abs(times[0] - block["begin_s"]), 0.0011)
                self.assertLess(abs(times[-1] - times[0] - block["duration_s"]), 0.0021)

    def test_shows_what_is_in_force_before_the_line(self):
        path = self.path("modes.ngc", "G21 G90 G18\nG1 X1 F600\nG91 G2 X2 I1\nM3 S500\nG0 X3\nM30\n")
        block = json.loads(self.kerf("explain", path, "--line", "3", "--json").stdout)["block"]
        self.assertEqual(block["text"], "G91 G2 X2 I1")
        self.assertEqual(block["position_mm"], {"x": 1.0, "y": 0.0, "z": 0.0})
        for code in ("G1", "G18", "G90", "G94", "M5"):
            self.assertIn(code, block["codes"])
        block = json.loads(self.kerf("explain", path, "--line", "5", "--json").stdout)["block"]
        for code in ("G2", "G91", "M3"):
            self.assertIn(code, block["codes"])
        self.assertEqual(block["spindle_speed"], 500.0)
        self.assertEqual(block["position_mm"]["x"], 3.0)

    def test_shows_the_offsets_in_force(self):
        path = self.path("offsets.ngc", "G21 G90\nG10 L2 P2 X10 Y20 Z0 R90\nG55 T1 M6\nG43.1 Z12.5\nM8\nG0 X1 Y2 Z3\nM30\n")
        block = json.loads(self.kerf("explain", path, "--line", "7", "--json").stdout)["block"]
        for code in ("G55", "G43", "M8", "G97"):
            self.assertIn(code, block["codes"])
        # Turned by a quarter: X of the program is Y of the machine, Y is -X.
        for axis, value in (("x", 10 - 2), ("y", 20 + 1), ("z", 3 + 12.5)):
            self.assertAlmostEqual(block["position_mm"][axis], value)
        self.assertAlmostEqual(block["program_position_mm"]["y"], 2.0)
        self.assertEqual((block["tool"], block["tool_offset_mm"]["z"]), (1, 12.5))
        text = self.kerf("explain", path, "--line", "7").stdout
        self.assertIn("x 8.000, y 21.000, z 15.500 mm on the machine", text)
        self.assertIn("turned by 90 degrees", text)

    def test_counts_dwells_and_events_as_time_of_their_line(self):
        path = self.path("dwell.ngc", "G21 G90\nG1 X1 F600\nG4 P0.5\nG4 P0.25\nM3 S1\nG90\nG1 X2\nM30\n")
        blocks = [json.loads(self.kerf("explain", path, "--line", str(line), "--json").stdout)["block"]
                  for line in (3, 4, 5, 6, 7)]
        self.assertAlmostEqual(blocks[0]["duration_s"], 0.5)
        self.assertAlmostEqual(blocks[1]["begin_s"] - blocks[0]["begin_s"], 0.5)
        self.assertAlmostEqual(blocks[1]["duration_s"], 0.25)
        for block in blocks[2:]:
            self.assertAlmostEqual(block["begin_s"] - blocks[1]["begin_s"], 0.25)
        self.assertEqual(blocks[3]["duration_s"], 0.0)

    def explained(self, path, line, *words):
        return json.loads(self.kerf("explain", path, "--line", str(line), "--json", *words).stdout)["block"]

    def test_knows_when_a_statement_was_first_reached(self):
        path = self.path("flow.ngc", "o<a> sub\nG0 X#1\no<a> endsub\nG21 G90\n#1=1\no1 while [#1 LT 3]\n"
                                     "o<a> call [#1]\n#1=[#1+1]\no1 endwhile\no2 if [0]\no2 elseif [1]\no2 endif\nM2\n")
        for line, text, x in ((1, "o<a> sub", 0.0), (3, "o<a> endsub", 1.0), (6, "o1 while [#1 LT 3]", 0.0),
                              (7, "o<a> call [#1]", 0.0), (9, "o1 endwhile", 1.0), (10, "o2 if [0]", 2.0),
                              (11, "o2 elseif [1]", 2.0), (12, "o2 endif", 2.0)):
            block = self.explained(path, line)
            self.assertEqual((block["text"], block["position_mm"]["x"]), (text, x))
        path = self.path("macro.nc", "O1 (MAIN)\n#1=1\nWHILE [#1 LE 2] DO1\nG0 X#1\n#1=#1+1\nEND1\n"
                                     "IF [#1 EQ 3] THEN #2=7\nIF [#1 EQ 3] GOTO 9\nGOTO 1\nN9 M30\n")
        for line, text, x in ((1, "O1 (MAIN)", 0.0), (3, "WHILE [#1 LE 2] DO1", 0.0), (6, "END1", 1.0),
                              (7, "IF [#1 EQ 3] THEN #2=7", 2.0), (8, "IF [#1 EQ 3] GOTO 9", 2.0)):
            block = self.explained(path, line, "--dialect", "fanuc")
            self.assertEqual((block["text"], block["position_mm"]["x"]), (text, x))
        said = self.kerf("explain", path, "--line", "9", "--dialect", "fanuc", status=1).stderr
        self.assertIn("line 9 is never run", said)

    def test_says_so_where_a_line_is_never_run(self):
        path = self.path("square.ngc", SQUARE)
        self.assertIn("line 99 is never run", self.kerf("explain", path, "--line", "99", status=1).stderr)
        self.kerf("explain", path, status=2)


class LiveInput(Case):
    """`kerf run -` on a pipe: motion begins before the text ends."""

    def start(self, *words):
        child = subprocess.Popen([KERF, "run", "-", "--json", *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        self.addCleanup(child.kill)
        return child

    def finish(self, child, more="", status=0):
        out, err = child.communicate(more, timeout=60)
        self.assertEqual(child.returncode, status, out + err)
        return json.loads(out), err

    def test_moves_while_the_input_is_still_open(self):
        child = self.start()
        child.stdin.write("G21 G90\nF3000\nG1 X10\n")
        child.stdin.flush()
        time.sleep(2.0)
        report, _ = self.finish(child, "G1 X20\nM30\n")
        self.assertEqual(report["extents"]["max_mm"]["x"], 20.0)
        # Had it waited for the end, nothing would have stood still between the two moves.
        waited = [w for w in report["warnings"] if w.startswith("waited for text: ")]
        self.assertEqual(len(waited), 1, report["warnings"])
        self.assertGreater(report["cycle_time_s"], 1.0)

    def test_is_stopped_by_a_request_while_it_waits(self):
        child = self.start()
        child.stdin.write("G21 G90\nG1 X10 F3000\n")
        child.stdin.flush()
        time.sleep(1.5)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=30)
        self.assertEqual(child.returncode, 130, out + err)

    def test_stops_at_rest_before_a_wrong_block(self):
        child = self.start()
        report, err = self.finish(child, "G21 G90\nG1 X10 F3000\nG77\nG1 X20\nM30\n", status=1)
        self.assertIn("<stdin>:3:1: error: G77 is not known", err)
        self.assertEqual(report["extents"]["max_mm"]["x"], 10.0)

    def test_stops_at_rest_before_a_block_that_leaves_the_table(self):
        child = self.start()
        report, err = self.finish(child, TOO_FAR, status=4)
        self.assertIn("<stdin>:3:1: error: ", err)
        self.assertEqual(report["extents"]["max_mm"]["x"], 10.0)


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


class Errors(Case):
    def test_a_wrong_program_is_1_with_places_that_editors_understand(self):
        path = self.path("wrong.ngc", WRONG)
        for command in ("dry-run", "run", "check"):
            done = self.kerf(command, path, status=1)
            lines = done.stderr.splitlines()
            self.assertRegex(lines[0], r"^.*/wrong\.ngc:3:5: error: .+ \[E0040\]$")
            self.assertEqual(lines[1:3], ["    G1 Xq", "        ^"])
            self.assertRegex(lines[3], r"^.*/wrong\.ngc:5:1: error: .+ \[E0100\]$")
            self.assertEqual(lines[4:6], ["    G77", "    ^"])
            self.assertEqual(done.stdout, "")

    def test_a_path_beyond_the_travel_shows_its_block(self):
        lines = self.kerf("check", self.path("far.ngc", TOO_FAR), status=4).stderr.splitlines()
        at = next(i for i, line in enumerate(lines) if "[E1000]" in line)
        self.assertEqual(lines[at + 1:at + 3], ["    G1 X1000", "    ^"])

    def test_a_path_beyond_the_travel_in_a_subprogram_names_its_file_and_shows_its_block(self):
        self.path("big.ngc", "o<big> sub\n  G1 X1000 F100\no<big> endsub\nM2\n")
        lines = self.kerf("check", self.path("main.ngc", "G21\n\no<big> call\nM2\n"), status=4).stderr.splitlines()
        self.assertRegex(lines[0], r"^\S*big\.ngc:2:3: error: x goes .+ \[E1000\]$")
        self.assertEqual(lines[1:3], ["      G1 X1000 F100", "      ^"])

    def test_warnings_have_the_same_form_and_quiet_leaves_them_out(self):
        path = self.path("open.ngc", "G21 G90\nM6\n")
        done = self.kerf("dry-run", path)
        self.assertRegex(done.stderr, r"open\.ngc:2:1: warning: .+ \[E0127\]\n    M6\n    \^\n")
        self.assertEqual(self.kerf("dry-run", "--quiet", path).stderr, "")

    def test_a_wrong_program_leaves_no_trace(self):
        self.kerf("dry-run", self.path("wrong.ngc", WRONG), "--trace", self.path("t.csv"), status=1)
        self.assertFalse(os.path.exists(self.path("t.csv")))

    def test_wrong_use_is_2(self):
        for words in ([], ["mill"], ["dry-run"], ["dry-run", "x.ngc", "--window", "0"], ["run", "a", "b"],
                      ["dry-run", "x.ngc", "--profile", "none"]):
            with self.subTest(words=words):
                done = self.kerf(*words, status=2)
                self.assertTrue(done.stderr.startswith("kerf: "))
                self.assertEqual(done.stdout, "")

    def test_help_and_version_are_0_and_go_to_standard_output(self):
        self.assertIn("dry-run", self.kerf("--help").stdout)
        self.assertIn("--trace", self.kerf("dry-run", "--help").stdout)
        self.assertRegex(self.kerf("--version").stdout, r"^kerf \d+\.\d+\.\d+\n$")

    def test_a_wrong_machine_file_is_3_with_line_and_column(self):
        machine = self.path("mill.toml", "[tick]\nperiod_s = 0.001\nspeed = 3\n")
        done = self.kerf("dry-run", self.path("square.ngc", SQUARE), "--machine", machine, status=3)
        self.assertRegex(done.stderr, r"mill\.toml:3:\d+: error: ")

    def test_the_tool_table_comes_from_the_option_or_from_beside_the_machine_file(self):
        program = self.path("long.ngc", "G43 H7 G0 Z1\nM2\n")
        refused = self.kerf("check", program, "--tools", self.path("short.tbl", "T1 Z3\n"), status=1)
        self.assertIn("H7 is not in the tool table", refused.stderr)
        taken = self.kerf("check", program, "--tools", self.path("own.tbl", "T7 Z30 ;long\n"))
        self.assertIn("z 0.000 to 31.000 mm", taken.stdout)
        limits = "[path]\nmax_velocity_mm_s = 9\nmax_acceleration_mm_s2 = 9\nmax_jerk_mm_s3 = 9\n"
        machine = self.path("mill.toml", limits + '[tools]\nfile = "own.tbl"\n')
        self.assertIn("z 0.000 to 31.000 mm", self.kerf("check", program, "--machine", machine).stdout)
        wrong = self.kerf("check", program, "--tools", self.path("wrong.tbl", "T1\nT2 D-1\n"), status=3)
        self.assertIn("wrong.tbl:2:4: error: D (diameter) must not be negative", wrong.stderr)
        missing = self.kerf("check", program, "--tools", self.path("none.tbl"), status=5)
        self.assertIn("none.tbl: error: ", missing.stderr)

    def test_a_program_beyond_the_travel_is_4_and_names_the_line(self):
        done = self.kerf("dry-run", self.path("far.ngc", TOO_FAR), status=4)
        self.assertRegex(done.stderr, r"far\.ngc:3:\d+: error: .*x.*limit")
        self.assertEqual(done.stdout, "")

    def test_a_following_error_is_4_and_names_the_line(self):
        shipped = (pathlib.Path(SOURCE) / "programs/machines/table.toml").read_text()
        machine = self.path("stiff.toml", shipped.replace("max_following_error_mm = 5", "max_following_error_mm = 0.0001"))
        done = self.kerf("dry-run", self.path("square.ngc", SQUARE), "--machine", machine, status=4)
        self.assertRegex(done.stderr, r"machine fault: following error of axis x too large, in line 3")
        self.assertIn("stopped by a fault of the machine", done.stdout)

    def test_a_file_that_cannot_be_read_is_5(self):
        self.assertIn("No such file", self.kerf("dry-run", "/nowhere.ngc", status=5).stderr)
        self.assertIn("Is a directory", self.kerf("dry-run", str(self.folder), status=5).stderr)
        square = self.path("square.ngc", SQUARE)
        self.assertIn("No such file", self.kerf("dry-run", square, "--machine", "/nowhere.toml", status=5).stderr)
        self.assertIn("Is a directory", self.kerf("dry-run", square, "--machine", str(self.folder), status=5).stderr)

    def test_a_full_disk_is_5_and_the_motion_goes_on(self):
        square = self.path("square.ngc", SQUARE)
        for command in ("dry-run", "run"):
            for option in ("--trace", "--plot"):
                with self.subTest(command=command, option=option):
                    done = self.kerf(command, square, option, "/dev/full", status=5)
                    self.assertIn("No space left on device", done.stderr)
                    self.assertIn("path            80.000 mm", done.stdout)

    def test_a_trace_or_plot_that_cannot_be_opened_is_5_before_anything_moves(self):
        square = self.path("square.ngc", SQUARE)
        for option in ("--trace", "--plot"):
            done = self.kerf("run", square, option, "/nowhere/x", status=5)
            self.assertEqual(done.stdout, "")

    def test_a_full_disk_behind_standard_output_is_5(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([KERF, "dry-run", self.path("square.ngc", SQUARE)], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 5)

    def test_a_closed_pipe_is_no_error(self):
        for words in (["--json"], ["--trace", "-"]):
            with self.subTest(words=words):
                command = [KERF, "dry-run", self.path("square.ngc", SQUARE), *words]
                reading, writing = os.pipe()
                os.close(reading)
                done = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, timeout=60)
                os.close(writing)
                self.assertEqual(done.returncode, 0, done.stderr)


class Trace(Case):
    HEADER = "t_s,line,s_mm,v_mm_s,a_mm_s2,j_mm_s3,x_mm,y_mm,z_mm,actual_x_mm,actual_y_mm,actual_z_mm"

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
        self.assertTrue(all(line.count(",") == 11 for line in lines))
        self.assertIn("square.ngc: done", done.stderr)


class Json(Case):
    KEYS = ("schema_version", "file", "command", "exit_status", "machine", "profile", "period_s", "cycle_time_s", "ticks",
            "path_length_mm", "blocks", "extents", "max", "limits_exceeded", "chord_error_mm", "contour_error",
            "following_error", "starved_ticks", "warnings", "errors", "elapsed")

    def test_is_one_object_with_the_documented_keys(self):
        report = json.loads(self.kerf("dry-run", "--json", self.path("square.ngc", SQUARE)).stdout)
        self.assertEqual(tuple(report), self.KEYS)
        documented = (pathlib.Path(SOURCE) / "docs/json.md").read_text()
        for key in self.KEYS:
            self.assertIn(f"`{key}`", documented)
        self.assertAlmostEqual(report["cycle_time_s"], report["ticks"] * 0.001)
        self.assertEqual(report["max"].keys(), {"path", "axes"})
        self.assertEqual(report["extents"]["max_mm"], {"x": 20.0, "y": 20.0, "z": 0.0})

    def test_of_a_run_counts_late_ticks(self):
        report = json.loads(self.kerf("run", "--json", self.path("square.ngc", SQUARE)).stdout)
        self.assertIsInstance(report["late_ticks"], int)
        self.assertGreaterEqual(report["worst_delay_s"], 0)

    def test_of_several_files_is_a_line_for_each(self):
        square = self.path("square.ngc", SQUARE)
        lines = self.kerf("check", "--json", square, square).stdout.splitlines()
        self.assertEqual([json.loads(line)["command"] for line in lines], ["check", "check"])

    def test_tells_errors_too(self):
        report = json.loads(self.kerf("dry-run", "--json", self.path("wrong.ngc", WRONG), status=1).stdout)
        self.assertEqual(report["exit_status"], 1)
        self.assertEqual([error["line"] for error in report["errors"]], [3, 5])

    def test_says_by_how_much_a_spline_exceeds_the_limits_of_the_axes(self):
        program = os.path.join(SOURCE, "programs/butterfly.ngc")
        done = self.kerf("dry-run", "--json", program)
        report = json.loads(done.stdout)
        jerk = next(e for e in report["limits_exceeded"] if e["where"] == "x" and e["quantity"] == "jerk")
        self.assertAlmostEqual(jerk["ratio"], jerk["value"] / jerk["limit"])
        self.assertGreater(jerk["ratio"], 2)
        self.assertTrue(any("axis x jerk" in warning for warning in report["warnings"]))
        self.assertIn("kerf: warning: ", done.stderr)


class Format(Case):
    def test_of_a_check_is_one_document_on_standard_output(self):
        files = [self.path("square.ngc", SQUARE), self.path("wrong.ngc", WRONG), self.path("far.ngc", TOO_FAR)]
        done = self.kerf("check", "--format", "json", *files, status=1)
        document = json.loads(done.stdout)
        self.assertEqual((document["schema"], document["schema_version"]), ("kerf-diagnostics", 1))
        errors = [d for d in document["diagnostics"] if d["severity"] == "error"]
        self.assertEqual([(d["file"], d["line"], d["id"]) for d in errors],
                         [(files[1], 3, "E0040"), (files[1], 5, "E0100"), (files[2], 3, "E1000")])
        self.assertEqual(done.stderr, "")

    def test_of_a_run_is_on_standard_error(self):
        path = self.path("wrong.ngc", WRONG)
        for command in ("dry-run", "run"):
            done = self.kerf(command, "--format", "json", path, status=1)
            self.assertEqual(json.loads(done.stderr)["diagnostics"][0]["line"], 3)
            self.assertEqual(done.stdout, "")

    def test_of_a_good_run_leaves_the_summary_and_the_report_alone(self):
        path = self.path("square.ngc", SQUARE)
        done = self.kerf("dry-run", "--format", "sarif", path)
        self.assertEqual(json.loads(done.stderr)["runs"][0]["results"], [])
        self.assertIn("cycle time", done.stdout)
        done = self.kerf("dry-run", "--format", "json", "--json", path)
        self.assertEqual(json.loads(done.stdout)["exit_status"], 0)
        self.assertEqual(json.loads(done.stderr)["diagnostics"], [])

    def test_sarif_names_files_lines_and_rules(self):
        path = self.path("wrong.ngc", WRONG)
        run = json.loads(self.kerf("check", "--format", "sarif", path, status=1).stdout)["runs"][0]
        first = run["results"][0]
        place = first["locations"][0]["physicalLocation"]
        self.assertEqual(place["region"], {"startLine": 3, "startColumn": 5})
        self.assertEqual(place["artifactLocation"]["uri"], pathlib.Path(path).resolve().as_uri())
        self.assertEqual(run["tool"]["driver"]["rules"][first["ruleIndex"]]["id"], first["ruleId"])
        self.assertEqual(run["invocations"][0]["exitCode"], 1)

    def test_holds_what_has_no_place(self):
        done = self.kerf("check", "--format", "json", self.path("none.ngc"), status=5)
        self.assertIn("none.ngc", json.loads(done.stdout)["failures"][0]["message"])
        machine = self.path("mill.toml", "[tick]\nspeed = 3\n")
        done = self.kerf("check", "--format", "sarif", "--machine", machine, self.path("square.ngc", SQUARE), status=3)
        run = json.loads(done.stdout)["runs"][0]
        self.assertFalse(run["invocations"][0]["executionSuccessful"])
        self.assertEqual(done.stderr, "")

    def test_does_not_share_standard_output_with_the_report(self):
        path = self.path("square.ngc", SQUARE)
        self.assertIn("--format", self.kerf("check", "--json", "--format", "sarif", path, status=2).stderr)
        self.assertIn("--format", self.kerf("check", "--format", "xml", path, status=2).stderr)


class ErrorPages(Case):
    def test_are_listed_and_shown(self):
        listed = self.kerf("errors").stdout.splitlines()
        self.assertIn("E0100  error    unknown G code", listed)
        self.assertTrue(self.kerf("errors", "E0100").stdout.startswith("E0100: error: unknown G code\n"))
        self.assertIn("E9999", self.kerf("errors", "E9999", status=2).stderr)

    def test_are_the_document(self):
        document = (pathlib.Path(SOURCE) / "docs/errors.md").read_text()
        self.assertEqual(self.kerf("errors", "--markdown").stdout, document)


class Check(Case):
    def test_is_a_line_for_each_file(self):
        path = self.path("square.ngc", SQUARE)
        done = self.kerf("check", path, self.path("wrong.ngc", WRONG), path, status=1)
        line = r".*/square\.ngc: ok, 0:00:0\d\.\d{3}, 80\.000 mm in 4 blocks, x 0\.000 to 20\.000, .* mm\n"
        self.assertRegex(done.stdout, f"^{line}{line}$")

    def test_plans_the_same_as_a_dry_run(self):
        for name in ("butterfly", "pocket", "polygon"):
            program = os.path.join(SOURCE, "programs", name + ".ngc")
            checked = json.loads(self.kerf("check", "--json", program).stdout)
            ran = json.loads(self.kerf("dry-run", "--json", program).stdout)
            for key in ("ticks", "cycle_time_s", "blocks", "extents"):
                self.assertEqual(checked[key], ran[key], (name, key))
            self.assertAlmostEqual(checked["path_length_mm"], ran["path_length_mm"], places=6)
            self.assertNotIn("max", checked)


class Plot(Case):
    def test_is_xml_of_bounded_size(self):
        path = self.path("plot.svg")
        self.kerf("dry-run", os.path.join(SOURCE, "programs/butterfly.ngc"), "--plot", path)
        root = xml.etree.ElementTree.parse(path).getroot()
        self.assertTrue(root.tag.endswith("svg"))
        texts = [element.text or "" for element in root.iter() if element.tag.endswith("text")]
        for words in ("v, mm/s", "feedrate, mm/s", "rapid", "time, s"):
            self.assertIn(words, texts)
        self.assertLess(os.path.getsize(path), 1_000_000)


class Signals(Case):
    def start(self, *words):
        process = subprocess.Popen([KERF, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        return process

    def wait_for_rows(self, path, process):
        deadline = time.monotonic() + 60
        while not (os.path.exists(path) and os.path.getsize(path) > 100_000):
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)

    def stopped_run(self, number, status):
        trace = self.path("trace.csv")
        process = self.start("run", self.path("long.ngc", LONG), "--trace", trace)
        self.wait_for_rows(trace, process)
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, status, err)
        self.assertIn("stopped on the path, as asked for", out)
        with open(trace) as file:
            return list(csv.DictReader(file))

    def test_interrupted_run_comes_to_rest_on_the_path_within_the_limits_and_is_130(self):
        rows = self.stopped_run(signal.SIGINT, 130)
        v = [float(row["v_mm_s"]) for row in rows]
        x = [float(row["x_mm"]) for row in rows]
        self.assertEqual(v[-1], 0.0)
        self.assertGreater(max(v), 9.0)
        self.assertTrue(all(float(row["y_mm"]) == 0.0 for row in rows))
        accelerations = [(a - 2 * b + c) / 1e-6 for a, b, c in zip(x[2:], x[1:], x)]
        self.assertLess(max(map(abs, accelerations)), 2500 * 1.01)
        jerks = [(a - b) / 1e-3 for a, b in zip(accelerations[1:], accelerations)]
        self.assertLess(max(map(abs, jerks)), 50000 * 1.02)

    def test_terminated_run_is_143(self):
        self.stopped_run(signal.SIGTERM, 143)

    def test_second_interrupt_ends_at_once(self):
        process = self.start("run", self.path("long.ngc", LONG), "--trace", self.path("trace.csv"))
        self.wait_for_rows(self.path("trace.csv"), process)
        process.send_signal(signal.SIGSTOP)
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGTERM)  # another number: two pending SIGINT would be one
        process.send_signal(signal.SIGCONT)
        process.communicate(timeout=60)
        self.assertIn(process.returncode, (130, 143))

    def test_interrupt_while_waiting_for_input_is_130(self):
        reading, writing = os.pipe()
        process = subprocess.Popen([KERF, "dry-run", "-"], stdin=reading, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.kill)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        os.close(reading), os.close(writing)
        self.assertEqual(process.returncode, 130)

    def test_interrupted_dry_run_is_130_and_prompt(self):
        trace = self.path("trace.csv")
        process = self.start("dry-run", self.path("long.ngc", LONG), "--trace", trace)
        while not os.path.exists(trace):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)

    def test_closed_standard_output_does_not_stop_a_run(self):
        command = [KERF, "run", self.path("square.ngc", SQUARE), "--trace", "-"]
        reading, writing = os.pipe()
        os.close(reading)
        begin = time.monotonic()
        done = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, text=True, timeout=60)
        os.close(writing)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("path            80.000 mm", done.stderr)
        self.assertGreater(time.monotonic() - begin, 80 / 50)


class ProgressBar(Case):
    def test_appears_on_a_terminal_after_a_second_and_goes(self):
        master, slave = pty.openpty()
        slow = "G21 G90\nF1200\nG1 X50\nM30\n"  # 2.5 s
        process = subprocess.Popen([KERF, "run", self.path("slow.ngc", slow)], stdout=subprocess.PIPE, stderr=slave,
                                   env={**os.environ, "TERM": "xterm"})
        os.close(slave)
        shown = b""
        while True:
            if select.select([master], [], [], 60)[0]:
                try:
                    piece = os.read(master, 4096)
                except OSError:
                    break
                if not piece:
                    break
                shown += piece
        process.communicate(timeout=60)
        os.close(master)
        self.assertEqual(process.returncode, 0)
        self.assertIn(b"running", shown)
        self.assertIn(b" %", shown)
        self.assertTrue(shown.endswith(b"\r\x1b[K"))

    def test_never_appears_in_a_pipe(self):
        slow = "G21 G90\nF1200\nG1 X30\nM30\n"
        self.assertEqual(self.kerf("run", self.path("slow.ngc", slow)).stderr.count("\r"), 0)


if __name__ == "__main__":
    KERF, SOURCE = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
