#!/usr/bin/env python3
"""What ends a program that does not end by itself: --max-time, --max-trace, and files that have no end."""
import json
import os
import subprocess

from command_line import Case, KERF, LONG, SQUARE, main

ENDLESS = "G21 G90\no1 while [1]\n  G1 X10 F60\n  G1 X0\no1 endwhile\nM2\n"
COMMANDS = (("check",), ("dry-run",), ("run",), ("explain", "--line", "3"))


class MaxTime(Case):
    def test_ends_an_endless_loop_with_motion_in_every_command(self):
        endless = self.path("endless.ngc", ENDLESS)
        for command in COMMANDS:
            with self.subTest(command=command):
                done = self.kerf(*command, endless, status=1)  # 30 days
                lines = done.stderr.splitlines()
                self.assertRegex(lines[0], r"endless\.ngc:[34]:3: error: up to here the program takes more than the "
                                           r"2592000 s that are allowed \[E1003\]$")
                self.assertRegex(lines[1], r"^ {6}G1 X")
                self.assertEqual(done.stdout, "")

    def test_or_too_many_moves_end_an_endless_loop(self):
        endless = self.path("endless.ngc", "G21 G90 F600\no1 while [1]\nG1 X0.001\nX0\no1 endwhile\nM2\n")
        for command in (("check",), ("dry-run",), ("explain", "--line", "4")):
            with self.subTest(command=command):
                done = self.kerf(*command, endless, "--max-moves", "10000", status=1)
                self.assertIn("up to here the program has more than the 10000 moves that are allowed [E1006]", done.stderr)

    def test_ends_an_endless_loop_of_dwells(self):
        endless = self.path("endless.ngc", "o1 while [1]\nG4 P1000\nG0 X1\nG0 X0\no1 endwhile\nM2\n")
        self.assertIn("E1003", self.kerf("check", endless, status=1).stderr)

    def test_is_asked_of_what_is_planned_too(self):
        # By its length alone 19.999 s, with its ramps more than 20 s.
        slow = self.path("slow.ngc", "G21 G90\nG1 X19.999 F60\nM2\n")
        self.kerf("check", slow, "--max-time", "21s")
        for command in (("check",), ("explain", "--line", "2"), ("dry-run",)):
            with self.subTest(command=command):
                done = self.kerf(*command, slow, "--max-time", "20s", status=1)
                self.assertRegex(done.stderr, r"slow\.ngc:2:1: error: up to here the program takes more than the 20 s that are "
                                              r"allowed \[E1003\]\n {4}G1 X19\.999 F60\n")

    def test_tells_a_program_that_is_too_long_as_one_with_an_error(self):
        slow = self.path("slow.ngc", "G21 G90\nG1 X19.999 F60\nM2\n")
        for command in (("check",), ("dry-run",)):
            with self.subTest(command=command):
                report = json.loads(self.kerf(*command, slow, "--max-time", "20s", "--json", status=1).stdout)
                self.assertEqual([(error["line"], error["id"]) for error in report["errors"]], [(2, "E1003")])
                self.assertNotIn("cycle_time_s", report)
        report = json.loads(self.kerf("dry-run", slow, "--max-time", "20s", "--explain-speed", "--json", status=1).stdout)
        self.assertNotIn("speed_limits", report, "shares of no whole")

    def test_more_headings_than_are_kept_are_told(self):
        for headings, told in ((9999, 0), (10001, 1)):
            part = self.path("part.ngc", "G61\n" + "".join(f"(op {i})\n" for i in range(headings)) + "G1 X1 F6000\nM2\n")
            report = json.loads(self.kerf("dry-run", part, "--json").stdout)
            self.assertEqual(sum("comments are headings" in warning for warning in report["warnings"]), told)

    def test_takes_seconds_minutes_hours_and_days(self):
        slow = self.path("slow.ngc", "G21 G90\nG1 X100 F60\nM2\n")
        for time, status in (("99", 1), ("101", 0), ("1.5min", 1), ("2min", 0), ("0.02h", 1), ("0.03h", 0), ("1d", 0)):
            with self.subTest(time=time):
                self.kerf("check", slow, "--max-time", time, status=status)

    def test_leaves_live_text_alone(self):
        done = subprocess.run([KERF, "run", "-", "--max-time", "0.1"], input=SQUARE, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)


class Work(Case):
    def test_of_a_check_does_not_grow_with_the_time_of_a_program(self):
        # 11 years. In parts of a tenth of a second, as a run sends a cruise, it would be 4e9 of them.
        program = self.path("snail.ngc", "G21 G90 G17\nG1 X60 F0.00001\nG2 X61 I0.5\nM2\n")
        for profile in ("time-optimal", "s-curve", "trapezoid"):
            with self.subTest(profile=profile):
                done = self.kerf("check", "--json", program, "--max-time", "100000d", "--profile", profile)
                report = json.loads(done.stdout)
                self.assertAlmostEqual(report["cycle_time_s"] / ((60 + 3.14159265 / 2) / 0.00001 * 60), 1, places=2)


class MaxTrace(Case):
    def test_ends_a_dry_run_and_names_the_line(self):
        trace = self.path("t.csv")
        done = self.kerf("dry-run", self.path("long.ngc", LONG), "--trace", trace, "--max-trace", "1MB", status=5)
        self.assertRegex(done.stderr, r"t\.csv: would be larger than 1000000 bytes \(--max-trace\), in line 3; the trace is "
                                      r"incomplete; what was written is in \S*t\.csv\.incomplete")
        self.assertFalse(os.path.exists(trace))
        size = os.path.getsize(trace + ".incomplete")
        self.assertTrue(999_000 < size <= 1_000_000, size)

    def test_lets_a_run_go_on(self):
        square = self.path("square.ngc", SQUARE)
        done = self.kerf("run", square, "--trace", self.path("t.csv"), "--max-trace", "100kB", status=5)
        self.assertIn("path            80.000 mm", done.stdout)
        self.assertIn("would be larger than 100000 bytes", done.stderr)

    def test_takes_a_trace_that_is_as_large_as_it_may_be(self):
        square, trace = self.path("square.ngc", SQUARE), self.path("t.csv")
        self.kerf("dry-run", square, "--trace", trace)
        size = os.path.getsize(trace)
        self.kerf("dry-run", square, "--trace", trace, "--max-trace", str(size))
        self.assertEqual(os.path.getsize(trace), size)
        self.kerf("dry-run", square, "--trace", trace, "--max-trace", str(size - 1), status=5)


class Outputs(Case):
    def test_standard_output_by_its_path_keeps_its_name_where_it_is_a_file(self):
        path = self.path("out.csv")
        with open(path, "w+") as out:
            done = subprocess.run([KERF, "dry-run", "-q", self.path("square.ngc", SQUARE), "--trace", "/dev/stdout"], stdout=out, timeout=60)
            self.assertTrue(out.readline().startswith("t_s,"))
        self.assertEqual(done.returncode, 0)
        self.assertEqual(sorted(os.listdir(self.folder)), ["out.csv", "square.ngc"])


class NoRegularFile(Case):
    def test_is_refused_as_program_machine_file_and_tool_table(self):
        fifo = self.path("fifo")
        os.mkfifo(fifo)
        square = self.path("square.ngc", SQUARE)
        for path, kind in ((fifo, "FIFO"), ("/dev/zero", "device")):
            for command in COMMANDS:
                if command != ("run",) or path != fifo:  # it waits for the text of that
                    with self.subTest(command=command, path=path):
                        done = self.kerf(*command, path, status=5)
                        self.assertIn(f"{path}: is a {kind}, not a regular file", done.stderr)
            for option in ("--machine", "--tools"):
                with self.subTest(option=option, path=path):
                    done = self.kerf("check", square, option, path, status=5)
                    self.assertIn(f"{path}: error: is a {kind}, not a regular file", done.stderr)

    def test_is_refused_as_standard_input_if_it_is_a_device(self):
        for command in ("check", "run"):
            with open("/dev/zero", "rb") as zero:
                done = subprocess.run([KERF, command, "-"], stdin=zero, capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 5)
            self.assertIn("<stdin>: is a device, neither a file nor a pipe", done.stderr)

    def test_is_run_as_its_text_comes_if_it_is_a_fifo(self):
        fifo = self.path("fifo")
        os.mkfifo(fifo)
        child = subprocess.Popen([KERF, "run", fifo, "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(child.kill)
        with open(fifo, "w") as writer:
            writer.write(SQUARE)
        out, err = child.communicate(timeout=60)
        self.assertEqual(child.returncode, 0, err)
        self.assertAlmostEqual(json.loads(out)["path_length_mm"], 80.0)


if __name__ == "__main__":
    main()
