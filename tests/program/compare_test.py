#!/usr/bin/env python3
"""What `kerf compare` says of two programs, and of one on two machines, beside what `kerf dry-run` says of each."""
import json
import os

from command_line import Case, SOURCE, TOO_FAR, WRONG, main

SLOW = "G21 G90 G17 G61\nG0 Z5\nF600\nG1 X20\nG1 Y20\nG1 X0\nG1 Y0\nM30\n"
FAST = "(the same, quicker)\nN1 G21 G90 G17 G61\nN2 G0 Z5\nN3 F1200\nN4 G1 X20\nN5 G1 Y20\nN6 G4 P1.5\nN7 G1 X0\nN8 G1 Y0\nN9 M30\n"
MACHINE = os.path.join(SOURCE, "programs/machines/sigmoid-butterfly.toml")


class Compare(Case):
    def both(self):
        return self.path("slow.ngc", SLOW), self.path("fast.ngc", FAST)

    def compare(self, *words, **more):
        return json.loads(self.kerf("compare", "--json", *words, **more).stdout)

    def cycle_time(self, *words):
        return json.loads(self.kerf("dry-run", "--json", *words).stdout)["cycle_time_s"]

    def assert_adds_up(self, difference):
        whole = difference["cycle_time"]["difference_s"]
        for parts in ("time_split", "speed_limits"):
            self.assertAlmostEqual(sum(part["difference_s"] for part in difference[parts].values()), whole, places=9)
        lines = sum(line["difference_s"] for line in difference["lines"])
        self.assertAlmostEqual(lines + difference["other_lines"]["difference_s"], whole, places=9)
        for line in difference["lines"]:
            for side in (line["first"], line["second"]):
                self.assertTrue(side is None or abs(sum(side["limits_s"].values()) - side["time_s"]) < 1e-9)

    def test_gives_the_times_of_two_dry_runs_and_their_difference(self):
        slow, fast = self.both()
        report = self.compare(slow, fast)
        times = [self.cycle_time(slow), self.cycle_time(fast)]
        self.assertEqual([program["cycle_time_s"] for program in report["programs"]], times)
        self.assertEqual(report["difference"]["cycle_time"],
                         {"first_s": times[0], "second_s": times[1], "difference_s": times[1] - times[0]})
        self.assertEqual((report["schema_version"], report["command"], report["exit_status"]), (1, "compare", 0))
        self.assert_adds_up(report["difference"])

    def test_finds_each_line_in_the_other_text(self):
        slow, fast = self.both()
        lines = self.compare(slow, fast)["difference"]["lines"]
        places = {(line["first"] and line["first"]["from_line"], line["second"] and line["second"]["from_line"]): line for line in lines}
        # 20 mm at 10 and at 20 mm/s, and what braking at the corners takes.
        for pair in ((4, 5), (5, 6), (6, 8), (7, 9)):
            self.assertAlmostEqual(places[pair]["difference_s"], -1.0, delta=0.1)
        self.assertAlmostEqual(places[(None, 7)]["difference_s"], 1.5, delta=0.002)
        self.assertEqual(places[(None, 7)]["second"]["text"], "N6 G4 P1.5")
        self.assertEqual(abs(lines[0]["difference_s"]), max(abs(line["difference_s"]) for line in lines))

    def test_says_where_a_program_that_does_not_fit_would(self):
        slow, _ = self.both()
        far = self.path("far.ngc", "G21 G90 G61 F3000\nG1 X100\nX620\nM2\n")
        done = self.kerf("compare", slow, far, status=4)
        self.assertEqual(done.stdout, f"{far}: does not fit\n"
                         "  x               0.000 to 620.000 mm, over by 120.000 mm; travel -500 to 500 mm\n"
                         "  would fit       G54 X between -600.000 and -120.000\n")

    def test_names_as_many_lines_as_are_asked_for(self):
        slow, fast = self.both()
        difference = self.compare(slow, fast, "--lines", "2")["difference"]
        self.assertEqual(len(difference["lines"]), 2)
        self.assertEqual(difference["other_lines"]["count"], 3)
        self.assert_adds_up(difference)

    def test_takes_one_program_on_two_machines_line_by_line(self):
        program = os.path.join(SOURCE, "programs/pocket.ngc")
        gentle = self.path("gentle.toml", "[path]\nmax_velocity_mm_s = 20\nmax_acceleration_mm_s2 = 200\nmax_jerk_mm_s3 = 5000\n")
        report = self.compare(program, "--machine", MACHINE, "--machine", gentle, "--lines", "1000")
        self.assertEqual([one["machine"] for one in report["programs"]], [MACHINE, gentle])
        self.assertEqual([one["cycle_time_s"] for one in report["programs"]],
                         [self.cycle_time(program, "--machine", machine) for machine in (MACHINE, gentle)])
        self.assert_adds_up(report["difference"])
        for line in report["difference"]["lines"]:
            self.assertEqual(line["first"]["from_line"], line["second"]["from_line"])

    def test_of_a_program_with_itself_finds_nothing(self):
        program = os.path.join(SOURCE, "programs/raster.ngc")
        difference = self.compare(program, program)["difference"]
        self.assertEqual(difference["cycle_time"]["difference_s"], 0)
        self.assertEqual((difference["lines"], difference["other_lines"]), ([], {"count": 0, "difference_s": 0}))
        self.assertIn("each line takes the same time in both", self.kerf("compare", program, program).stdout)

    def test_is_written_for_people(self):
        slow, fast = self.both()
        done = self.kerf("compare", slow, fast)
        for words in (f"{slow} on default\n", f"{fast} on default\n", "  difference      ", "    programmed feedrate ", "    none -> 7 ", "N6 G4 P1.5", "    4 -> 5 "):
            self.assertIn(words, done.stdout)
        self.assertEqual(done.stderr, "")
        self.assertEqual(self.kerf("compare", "-q", slow, fast).stdout, "")

    def test_takes_one_of_them_from_standard_input(self):
        slow, fast = self.both()
        difference = self.compare("-", fast, stdin=SLOW)["difference"]
        self.assertEqual(difference, self.compare(slow, fast)["difference"])

    def test_needs_both_to_run(self):
        slow, _ = self.both()
        for text, status in ((WRONG, 1), (TOO_FAR, 4)):
            for files in ((slow, self.path("bad.ngc", text)), (self.path("bad.ngc"), slow)):
                done = self.kerf("compare", *files, status=status)
                self.assertNotIn("difference", done.stdout)
                self.assertEqual(done.stdout == "", status == 1)  # else how it would fit
                self.assertIn("bad.ngc:", done.stderr)
                report = self.compare(*files, status=status)
                self.assertNotIn("difference", report)
                self.assertEqual(len(report["programs"]), 2)

    def test_is_wrong_use_without_two_of_something(self):
        slow, fast = self.both()
        for words in ((), (slow,), (slow, "--machine", MACHINE), (slow, fast, slow), ("-", "-"),
                      ("-", "--machine", MACHINE, "--machine", MACHINE), (slow, fast, *("--machine", MACHINE) * 3)):
            self.assertNotEqual(self.kerf("compare", *words, status=2).stderr, "")

    def test_asks_for_files_as_the_other_commands_do(self):
        self.assertIn("Usage: kerf compare [OPTIONS] FILE...\n", self.kerf("compare", "--help").stdout)


if __name__ == "__main__":
    main()
