#!/usr/bin/env python3
"""Each exit status of `kerf`, and that README.md, docs/json.md, the schema of the control channel and the help name them all."""
import json
import os
import pathlib
import re
import signal
import subprocess
import time

from command_line import Case, KERF, LONG, SOURCE, SQUARE, TOO_FAR, WRONG, main

# 6 is a defect, of which there is none to show: ExitStatus.OfADefectIs6 has it.
ALL = {0, 1, 2, 3, 4, 5, 6, 7, 8, 129, 130, 143}


class ExitStatus(Case):
    def test_of_what_ends_by_itself(self):
        square = self.path("square.ngc", SQUARE)
        far, wrong = self.path("far.ngc", TOO_FAR), self.path("wrong.ngc", WRONG)
        machine = self.path("mill.toml", "[tick]\nspeed = 3\n")
        for status, words in ((0, ["check", square]), (1, ["check", wrong]), (1, ["check", square, "--max-time", "0.1"]),
                              (2, ["check"]), (2, ["check", square, "--max-time", "soon"]), (3, ["check", square, "--machine", machine]),
                              (4, ["check", far]), (5, ["check", "/nowhere.ngc"]), (1, ["check", square, wrong, far]),
                              (4, ["check", square, far, wrong])):
            with self.subTest(words=words):
                self.kerf(*words, status=status)

    def test_of_files_that_would_be_written_over_however_they_are_named(self):
        square = pathlib.Path(self.path("square.ngc", SQUARE))
        folder = square.parent
        (folder / "link.ngc").symlink_to(square)
        os.link(square, folder / "hard.ngc")
        for name in (square, f"{folder}/./square.ngc", folder / "link.ngc", folder / "hard.ngc"):
            for option in ("--trace", "--log", "--record", "--plot"):
                with self.subTest(name=name, option=option):
                    self.assertIn("is not to be written over", self.kerf("dry-run", square, option, name, status=2).stderr)
                    self.assertEqual(square.read_text(), SQUARE)
        twice = self.path("twice")
        self.assertIn("would be written twice", self.kerf("dry-run", square, "--trace", twice, "--plot", f"{folder}/./twice", status=2).stderr)
        self.assertIn("would be written twice", self.kerf("dry-run", square, "--trace", "./not-there", "--plot", "not-there", status=2).stderr)
        self.kerf("dry-run", square, "--trace", "/dev/null", "--plot", "/dev/null")

    def test_of_a_subprogram_that_would_be_written_over(self):
        main = self.path("main.ngc", "G21 G61 F600\no<hole> call\nM2\n")
        hole = self.path("hole.ngc", "o<hole> sub\nG1 X1\no<hole> endsub\n")
        fanuc = self.path("O0007", "O7\nG1 X1\nM99\n")
        for option in ("--trace", "--log", "--record", "--plot"):
            for name in (hole, fanuc):
                with self.subTest(name=name, option=option):
                    before = pathlib.Path(name).read_text()
                    self.assertIn("may be a subprogram", self.kerf("dry-run", main, option, name, status=2).stderr)
                    self.assertEqual(pathlib.Path(name).read_text(), before)
        self.kerf("dry-run", main, "--trace", self.path("O7.csv"), "--log", self.path("new.ngc"))

    def test_of_files_of_the_machine_that_would_be_written_over(self):
        square = self.path("square.ngc", SQUARE)
        table = self.path("tools.tbl", "T1 Z3\n")
        surface = self.path("map.txt", "0 0 1\n10 0 1\n0 10 1\n10 10 1\n")
        limits = "[path]\nmax_velocity_mm_s = 90\nmax_acceleration_mm_s2 = 900\nmax_jerk_mm_s3 = 9000\n"
        mill = self.path("mill.toml", limits + '[tools]\nfile = "tools.tbl"\n[probe]\nheight_map = "map.txt"\n')
        for name in (table, surface):
            for option in ("--trace", "--log", "--record", "--plot"):
                with self.subTest(name=name, option=option):
                    before = pathlib.Path(name).read_text()
                    self.assertIn("is not to be written over", self.kerf("dry-run", square, "--machine", mill, option, name, status=2).stderr)
                    self.assertEqual(pathlib.Path(name).read_text(), before)
        # Also where the machine file is refused for what is in the table.
        wrong = self.path("tools.tbl", "T1 D-1\n")
        self.kerf("dry-run", square, "--machine", mill, "--log", wrong, status=2)
        self.assertEqual(pathlib.Path(wrong).read_text(), "T1 D-1\n")

    def test_of_programs_that_an_output_would_write_over_until_it_is_whole(self):
        program = self.path("a.csv.incomplete", SQUARE)
        self.kerf("dry-run", program, "--trace", self.path("a.csv"), status=2)
        self.assertEqual(pathlib.Path(program).read_text(), SQUARE)

    def test_of_a_start_that_nobody_can_give(self):
        square = self.path("square.ngc", SQUARE)
        self.assertIn("--wait-start needs", self.kerf("run", square, "--wait-start", stdin="", status=2).stderr)
        self.assertIn("--wait-start needs", self.kerf("run", "-", "--wait-start", stdin=SQUARE, status=2).stderr)

    def test_of_empty_names_of_files(self):
        square = self.path("square.ngc", SQUARE)
        for command, option in (("run", "--replay"), ("run", "--journal"), ("run", "--record"), ("run", "--flight-recorder"), ("dry-run", "--tools")):
            with self.subTest(option=option):
                self.kerf(command, square, option, "", status=2)

    def test_of_what_is_asked_to_stop(self):
        long = self.path("long.ngc", LONG)
        for status, number in ((129, signal.SIGHUP), (130, signal.SIGINT), (143, signal.SIGTERM)):
            trace = self.path(f"{status}.csv")
            process = subprocess.Popen([KERF, "run", long, "--trace", trace], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            self.addCleanup(process.kill)
            deadline = time.monotonic() + 60
            while not os.path.exists(trace + ".incomplete") and time.monotonic() < deadline:
                time.sleep(0.02)
            process.send_signal(number)
            process.communicate(timeout=60)
            self.assertEqual(process.returncode, status)

    def test_of_a_dry_run_that_is_asked_to_stop_and_does_so_at_once(self):
        long = self.path("long.ngc", "G21 G90 G61\nF600\n" + "G1 X200\nG1 X0\n" * 1000 + "M30\n")  # 40,000 s
        process = subprocess.Popen([KERF, "dry-run", long, "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        self.assertLess(json.loads(out)["cycle_time_s"], 20_000)

    def test_of_a_wait_that_nobody_can_answer_is_that_of_a_program_error_before_any_motion(self):
        for wait in ("M0", "M60", "T2 M6"):
            part = self.path("wait.ngc", f"G21 G90\nG1 X10 F6000\n{wait}\nX20\nM2\n")
            trace = self.path("wait.csv")
            said = self.kerf("run", part, "--trace", trace, status=1, stdin="").stderr
            self.assertIn("wait.ngc:3:1: error: the program waits for an answer here", said)
            self.assertFalse(os.path.exists(trace))
            self.kerf("dry-run", part)
        optional = self.path("optional.ngc", "G21 G90\nG1 X10 F6000\nM1\nX20\nM2\n")
        self.kerf("run", optional)
        self.assertIn("optional.ngc:3:1: error", self.kerf("run", optional, "--optional-stop", status=1, stdin="").stderr)

    def test_of_a_second_run_on_a_machine_is_5(self):
        machine = self.path("mill.toml", (pathlib.Path(SOURCE) / "programs/machines/sigmoid-butterfly.toml").read_text())
        trace = self.path("first.csv")
        first = subprocess.Popen([KERF, "run", self.path("long.ngc", LONG), "--machine", machine, "--trace", trace],
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(first.kill)
        deadline = time.monotonic() + 60
        while not os.path.exists(trace + ".incomplete") and time.monotonic() < deadline:
            time.sleep(0.02)
        square = self.path("square.ngc", SQUARE)
        said = self.kerf("run", square, "--machine", machine, status=5).stderr
        self.assertIn("mill.toml: another kerf run has this machine", said)
        self.kerf("dry-run", square, "--machine", machine)
        # An editor saves by putting another file in its place.
        os.replace(self.path("saved.toml", pathlib.Path(machine).read_text()), machine)
        self.assertIn("mill.toml: another kerf run has this machine", self.kerf("run", square, "--machine", machine, status=5).stderr)
        first.send_signal(signal.SIGINT)
        first.communicate(timeout=60)
        self.kerf("run", square, "--machine", machine)

    def test_is_documented(self):
        source = pathlib.Path(SOURCE)
        self.assertEqual({int(n) for n in re.findall(r"^  \w+ = (\d+),", (source / "programs/kerf/exit_status.hpp").read_text(), re.M)}, ALL)
        table = re.search(r"\| exit status \| \|\n\| --- \| --- \|\n((?:\|.*\n)+)", (source / "README.md").read_text()).group(1)
        cells = " ".join(re.findall(r"^\| ([\d, ]+) \|", table, re.M))
        self.assertEqual({int(n) for n in re.findall(r"\d+", cells)}, ALL)
        row = next(line for line in (source / "docs/json.md").read_text().splitlines() if line.startswith("| `exit_status`"))
        self.assertEqual({int(n) for n in re.findall(r"(?:: |, )(\d+) ", row)}, ALL)
        schema = (source / "docs/control.schema.json").read_text()
        named = re.search(r'"exit_status": {"enum": \[([\d, ]+)\]}', schema).group(1)
        self.assertEqual({int(n) for n in named.split(",")}, ALL)
        help_text = self.kerf("--help").stdout
        self.assertEqual({int(n) for n in re.findall(r"(?:: |, |,\n)(\d+) [a-z]", help_text[help_text.index("Exit status"):])}, ALL)


if __name__ == "__main__":
    main()
