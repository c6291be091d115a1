#!/usr/bin/env python3
"""`--from-line`: what is shown, where one can start, who confirms it, and the path from there on."""
import csv
import json
import os
import pathlib
import pty
import socket
import subprocess

from command_line import Case, KERF, SOURCE, in_time, main

PROGRAMS = pathlib.Path(SOURCE) / "programs"
# Exact path: one starts at any line of it.
SQUARE = "G21 G90 G61 F3000\nG0 X10 Y10 Z-2\nG1 Z-5\nX40\nY40\nX10\nY10\nG0 Z5\nM30\n"
COMPENSATED = "G21 G90 G61 F600\nG0 X-20 Y-20\nG41.1 D4 G1 X0 Y0\nY30\nX30\nG1 Y0\nG40 X60 Y-20\nX80\nM2\n"
ENDED = "G21 G90 G61 F600\nG0 X-20 Y-20\nG41.1 D4 G1 X0 Y0\nX40\nG40\n(beside the contour)\nG1 Y-20\nX50\nX60\nM2\n"  # G40 in a block of its own
CYCLE = "G21 G90 G61 F600\nG0 X1 Z5\nG81 X10 Y0 Z-2 R1\nX20\nX30\nG80\nG1 X40\nX50\nM2\n"
CURVE = "G21 G90 G61 F600\nG1 X1\nG6.2 P3 K0 X1 Y0 Z0\nK0 X5 Y5\nK0 X9 Y0\nK1\nK1\nK1\nG1 X20\nM2\n"
# Ten lines of a circle's edge, merged; then an exact way.
MEASURED = "G21 G90 F600\nG0 X10 Z0\nG38.2 Z-160\nG10 L20 P1 Z0\nG1 X20\nG1 Z1\nM2\n"
MERGED = ("G21 G90 G64 P0.05 Q0.05 F1200\nG1 X50 Y0\n" +
          "".join(f"X{50 - 0.02 * k * k:.4f} Y{2 * k}\n" for k in range(1, 11)) + "G61\nG1 X0\nY0\nM2\n")
ROUNDS = "G21 G90 G61 F3000\no1 sub\nG91 G1 X1\nY1\nG90\no1 endsub\n#1=0\no2 while [#1 LT 3]\no1 call\n#1=[#1+1]\no2 endwhile\nG1 X0\nM2\n"
TOP = 200.0  # of the default table
OF_EXPLAIN = ("begin_s", "duration_s", "line")
OF_START = ("round", "calls", "line")


class Start(Case):
    def started(self, program, line, *words):
        return json.loads(self.kerf("dry-run", program, "--from-line", str(line), "--json", "-q", *words).stdout)

    def rows(self, trace):
        with open(trace, encoding="utf-8") as file:
            return list(csv.DictReader(row for row in file if not row.startswith("#")))

    def test_shows_what_explain_shows(self):
        for name, step in (("star.ngc", 3), ("pocket.ngc", 17), ("mazatrol.ngc", 4), ("raster.ngc", 950), ("butterfly.ngc", 20)):
            program = str(PROGRAMS / name)
            for line in range(1, len(pathlib.Path(program).read_text().splitlines()) + 1, step):
                with self.subTest(program=name, line=line):
                    self.compare_with_explain(program, line)

    def compare_with_explain(self, program, line):
        """Where one cannot start, the place before it is taken, and explained."""
        done = subprocess.run([KERF, "dry-run", program, "--from-line", str(line), "--safe-line", "--json", "-q"], capture_output=True, text=True, timeout=120)
        explained = subprocess.run([KERF, "explain", program, "--line", str(line), "--json"], capture_output=True, text=True, timeout=120)
        if explained.returncode != 0:
            self.assertIn("is never run", explained.stderr)
            self.assertIn("is never run", done.stderr)
            return
        self.assertEqual(done.returncode, 0, done.stderr)
        start = json.loads(done.stdout)["start"]
        if start["line"] != line:
            explained = self.kerf("explain", program, "--line", str(start["line"]), "--json")
        block = json.loads(explained.stdout)["block"]
        self.assertEqual(start["line"], block["line"])
        self.assertEqual({key: value for key, value in start.items() if key not in OF_START},
                         {key: value for key, value in block.items() if key not in OF_EXPLAIN})

    def test_the_text_is_that_of_explain(self):
        program = self.path("square.ngc", SQUARE)
        shown = self.kerf("dry-run", program, "--from-line", "5").stderr
        explained = self.kerf("explain", program, "--line", "5").stdout
        self.assertEqual([line for line in explained.splitlines() if not line.startswith("  begins at")], shown.splitlines())

    def test_runs_the_path_that_is_left_and_ends_where_the_whole_ends(self):
        program = self.path("square.ngc", SQUARE)
        whole, rest = self.path("whole.csv"), self.path("rest.csv")
        self.kerf("dry-run", program, "--trace", whole, "-q")
        self.kerf("dry-run", program, "--from-line", "5", "--trace", rest, "-q")
        # From X40 Y10 Z-5: up, over it, down, then the lines 5 to 8 as they are programmed.
        corners = [(40, 10, -5), (40, 40, -5), (10, 40, -5), (10, 10, -5), (10, 10, 5)]
        places = [tuple(float(row[f"{axis}_mm"]) for axis in "xyz") for row in self.rows(rest)]
        begin = next(i for i, place in enumerate(places) if max(abs(a - b) for a, b in zip(place, corners[0])) < 1e-6)
        for place in places[begin:]:
            self.assertLess(min(off_line(place, a, b) for a, b in zip(corners, corners[1:])), 1e-6)
        for corner in corners:
            self.assertLess(min(max(abs(a - b) for a, b in zip(place, corner)) for place in places[begin:]), 0.06)
        last = self.rows(whole)[-1]
        for axis in "xyz":
            self.assertEqual(self.rows(rest)[-1][f"{axis}_mm"], last[f"{axis}_mm"])

    def test_the_extents_are_those_of_what_runs(self):
        program = self.path("square.ngc", SQUARE)
        box = {"min_mm": {"x": 0, "y": 0, "z": -5}, "max_mm": {"x": 40, "y": 40, "z": TOP}}
        extents = self.started(program, 5)["extents"]
        for end, axes in box.items():
            for axis, place in axes.items():
                self.assertAlmostEqual(extents[end][axis], place, places=6)
        self.assertIn("z -5.000 to 200.000 mm\n", self.kerf("dry-run", program, "--from-line", "5").stdout)

    def refused(self, text, line, *said):
        program = self.path("refused.ngc", text)
        stderr = self.kerf("dry-run", program, "--from-line", str(line), status=1).stderr
        for words in said:
            self.assertIn(words, stderr)

    def test_names_the_lines_around_a_curve_compensation_and_a_cycle(self):
        self.refused(CURVE, 5, "line 5 is no place to start at", "within a curve", "line 3 before it", "line 9 after it")
        self.refused(COMPENSATED, 5, "cutter compensation is on", "line 3 before it", "line 8 after it")
        for line in (6, 7):
            self.refused(ENDED, line, "cutter compensation ends with its motion", "line 3 before it", "line 8 after it")
        self.refused(CYCLE, 4, "a canned cycle is in force", "line 3 before it", "line 7 after it")

    def test_does_not_start_behind_a_probe_whose_machine_is_another(self):
        program = self.path("measured.ngc", MEASURED)
        stderr = self.kerf("run", program, "--from-line", "5", "--driver", "loopback", "--yes", status=1).stderr
        for words in ("line 5 is no place to start at", "after a probe", "one can start at line 3 before it"):
            self.assertIn(words, stderr)
        self.assertEqual(self.started(program, 5)["start"]["line"], 5)

    def test_says_that_it_guesses_what_another_machine_answered(self):
        program = self.path("asked.ngc", "G21 G90 G61 F600\nG1 X1\nM66 P0 L0\nG1 X2\nG1 X3\nM2\n")
        for line, driver, said in ((5, "loopback", True), (2, "loopback", False), (5, "simulated", False)):
            with self.subTest(line=line, driver=driver):
                stderr = self.kerf("run", program, "--from-line", str(line), "--driver", driver, status=2).stderr
                self.assertIn("nobody is there to confirm", stderr)
                self.assertEqual("answer to M66, first in line 3, is not known: taken as [simulation] has it" in stderr, said)

    def test_names_the_lines_around_a_merged_run(self):
        self.refused(MERGED, 6, "within a curve that G64 made of several lines", "line 3 before it", "after it")

    def test_any_line_of_a_straight_row_of_exact_lines_is_a_place(self):
        row = self.path("row.ngc", "G21 G90 G61 F6000\n" + "".join(f"G1 X{0.2 * i:.1f}\n" for i in range(1, 101)) + "M2\n")
        trace = self.path("rest.csv")
        for line in (2, 3, 50, 77, 101):
            self.kerf("dry-run", row, "--from-line", str(line), "--trace", trace, "-q")
            rows = self.rows(trace)
            reached = next(float(one["x_mm"]) for one in rows if int(one["line"]) > line)  # behind that line's end
            self.assertAlmostEqual(reached, 0.2 * (line - 1), delta=0.1)
            self.assertEqual(float(rows[-1]["x_mm"]), 20)

    def test_takes_the_line_before_where_it_is_asked_to(self):
        for text, line, before in ((CURVE, 5, 3), (COMPENSATED, 5, 3), (CYCLE, 4, 3), (MERGED, 6, 3)):
            program = self.path("moved.ngc", text)
            self.assertEqual(self.started(program, line, "--safe-line")["start"]["line"], before)

    def test_counts_how_often_a_line_runs_and_tells_its_calls(self):
        program = self.path("rounds.ngc", ROUNDS)
        for start, x, y in (("3", 0, 0), ("3:2", 1, 1), ("4:3", 3, 2)):
            told = self.started(program, start)["start"]
            self.assertEqual((told["position_mm"]["x"], told["position_mm"]["y"], told["calls"]), (x, y, [9]))
            self.assertEqual(f"{told['line']}:{told['round']}", start if ":" in start else start + ":1")
        stderr = self.kerf("dry-run", program, "--from-line", "4:2").stderr
        self.assertIn("  round           2\n  called from     line 9\n", stderr)
        self.assertIn("does not run 4 times", self.kerf("dry-run", program, "--from-line", "3:4", status=1).stderr)
        # From X0 Y0 Z0 over the top to X2 Y2, the third round, then X0.
        way = 2 * TOP + 8**0.5 + 2 + 3
        self.assertAlmostEqual(self.started(program, "3:3")["path_length_mm"], way, delta=1e-6)

    def test_a_line_that_never_runs_and_words_that_say_nothing(self):
        program = self.path("square.ngc", SQUARE)
        self.assertIn("line 99 is never run", self.kerf("dry-run", program, "--from-line", "99", status=1).stderr)
        for words in (["--from-line", "0"], ["--from-line", "3:0"], ["--from-line", "3:"], ["--from-line", "x"], ["--safe-line"],
                      ["--from-line", "3", "-"]):
            self.kerf("dry-run", program, *words, status=2)
        self.kerf("run", program, "--yes", status=2)

    def test_a_run_is_confirmed(self):
        program = self.path("square.ngc", SQUARE)
        done = self.kerf("run", program, "--from-line", "7", "--json", status=2)
        self.assertIn("--yes", done.stderr)
        self.assertEqual(json.loads(done.stdout)["exit_status"], 2)
        done = self.kerf("run", program, "--from-line", "7", "--yes")
        self.assertIn("  started at      line 7\n", done.stdout)
        self.assertIn("in force before it", done.stderr)

    def test_what_waits_before_the_start_needs_nobody_and_what_waits_behind_it_does(self):
        waits = self.path("waits.ngc", "G21 G90 G61 F6000\nM0\nG1 X5\nX9\nM0\nX10\nM2\n")
        self.assertIn(":5:1: error: the program waits for an answer here", self.kerf("run", waits, "--from-line", "3", "--yes", status=1).stderr)
        self.kerf("run", waits, "--from-line", "6", "--yes")
        # The tool of the line is changed in at the start.
        changes = self.path("changes.ngc", "G21 G90 G61 F6000\nM6 T1\nG1 X5\nX9\nM2\n")
        self.assertIn(":2:1: error: the program waits for an answer here", self.kerf("run", changes, "--from-line", "4", "--yes", status=1).stderr)

    def answered(self, answer, status):
        done = in_time(lambda: self.run_answered(answer), status)
        self.assertEqual(done.returncode, status)
        return done.stdout

    def run_answered(self, answer):
        terminal, end = pty.openpty()
        self.addCleanup(os.close, terminal)
        self.addCleanup(os.close, end)
        process = subprocess.Popen([KERF, "run", self.path("square.ngc", SQUARE), "--from-line", "7"], stdin=end, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, start_new_session=True, preexec_fn=lambda: os.close(os.open(os.ttyname(0), os.O_RDWR)))
        self.addCleanup(process.kill)
        os.write(terminal, answer)
        stdout, stderr = process.communicate(timeout=60)
        self.assertIn(b"Start there? [y/N]", stderr)
        return subprocess.CompletedProcess(process.args, process.returncode, stdout, stderr)

    def test_somebody_at_the_terminal_says_yes_or_no(self):
        self.assertIn(b"started at      line 7", self.answered(b"y\n", status=0))
        for no in (b"n\n", b"\n"):
            self.assertEqual(self.answered(no, status=7), b"")

    def test_over_the_control_channel_the_program_waits_at_its_place(self):
        ours, theirs = socket.socketpair()
        self.addCleanup(ours.close)
        trace = self.path("run.csv")
        process = subprocess.Popen([KERF, "run", self.path("square.ngc", SQUARE), "--from-line", "7", "--control", str(theirs.fileno()), "--trace", trace, "-q"],
                                   stdin=subprocess.DEVNULL, stderr=subprocess.PIPE, pass_fds=[theirs.fileno()])
        theirs.close()
        self.addCleanup(process.kill)
        lines = ours.makefile("rb")
        for line in lines:
            told = json.loads(line)
            if told.get("state") == "waiting" and told.get("waits_for") == "answer":
                self.assertEqual((told["line"], told["wait_cause"]), (7, "start"))
                break
        ours.sendall(b'{"command":"resume"}\n')
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)
        self.assertEqual([float(self.rows(trace)[0][f"{axis}_mm"]) for axis in "xyz"], [0.0, 0.0, 0.0])


def off_line(place, a, b):
    way = [q - p for p, q in zip(a, b)]
    length2 = sum(w * w for w in way)
    share = max(0.0, min(1.0, sum((x - p) * w for x, p, w in zip(place, a, way)) / length2))
    return sum((x - p - share * w) ** 2 for x, p, w in zip(place, a, way)) ** 0.5


if __name__ == "__main__":
    main(at_once=2)
