#!/usr/bin/env python3
"""`--explain-speed`: what limits the feedrate, in the report and in the trace."""
import csv
import json

from command_line import Case, SQUARE, main


class ExplainSpeed(Case):
    PROGRAM = SQUARE.replace("G1 Y20", "G4 P0.25\nG1 Y20")

    def test_adds_up_to_the_cycle_time_and_agrees_with_the_trace(self):
        for profile in ("s-curve", "sigmoid", "time-optimal"):
            trace = self.path("out.csv")
            done = self.kerf("dry-run", self.path("a.ngc", self.PROGRAM), "--explain-speed", "--json", "--trace", trace,
                             "--profile", profile)
            report = json.loads(done.stdout)
            limits = report["speed_limits"]
            self.assertAlmostEqual(sum(limit["share"] for limit in limits.values()), 1.0, places=9)
            self.assertAlmostEqual(sum(limit["time_s"] for limit in limits.values()), report["cycle_time_s"], places=9)
            self.assertAlmostEqual(limits["rest"]["time_s"], 0.25, delta=0.0021)  # the dwell
            self.assertEqual(report["stops"], 4)
            with open(trace) as file:
                rows = list(csv.DictReader(file))[:-1]  # no period begins with the last tick
            for name, limit in limits.items():
                self.assertEqual(sum(row["limit"] == name for row in rows), round(limit["time_s"] / 0.001), name)

    def test_counts_the_rests_of_axes_that_move_alone(self):
        turns = "min_deg = -720\nmax_deg = 720\nmax_velocity_deg_s = 100\nmax_acceleration_deg_s2 = 1000\nmax_jerk_deg_s3 = 10000\n"
        machine = self.path("turning.toml", "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\n[axes.a]\n" + turns)
        program = self.path("turn.ngc", "G21 G90 G61 F3000\nG1 X10\nG1 A90\nG1 A0\nG1 X0\nM2\n")
        report = json.loads(self.kerf("dry-run", program, "--machine", machine, "--explain-speed", "--json").stdout)
        self.assertEqual(report["stops"], 4)  # at the end of each of them

    def test_answers_for_a_line_and_for_an_instant(self):
        program = self.path("a.ngc", self.PROGRAM)
        report = json.loads(self.kerf("dry-run", program, "--explain-speed=4", "--json").stdout)
        self.assertEqual([line["line"] for line in report["speed_limits_of_lines"]], [4])
        self.assertEqual(list(report["speed_limits_of_lines"][0]["limits"]), ["rest"])
        report = json.loads(self.kerf("run", program, "--explain-speed=@0.3", "--json").stdout)
        self.assertEqual(report["speed_limit_at"]["limit"], "programmed_feedrate")
        self.assertAlmostEqual(report["speed_limit_at"]["v_mm_s"], 50.0)

    def test_counts_what_a_file_of_its_own_runs_for_the_line_that_calls_it(self):
        self.path("twice.ngc", "o<twice> sub\nX#1\nX0\no<back> call [#1]\no<twice> endsub\nM2\n")
        self.path("back.ngc", "o<back> sub\n\nY#1\nG4 P1\nY0\no<back> endsub\nM2\n")
        self.path("round.ngc", "o<round> sub\no<inner> call\nX3\no<round> endsub\nM2\n")
        program = self.path("a.ngc", "G21 G90 G61 F600\nG1 X30\nX0\n\no<twice> call [10]\no<inner> sub\nX5\no<back> call [5]\n"
                                     "o<inner> endsub\no<round> call\nX0\nM2\n")
        trace = self.path("out.csv")
        report = json.loads(self.kerf("dry-run", program, "--explain-speed=5", "--json", "--trace", trace).stdout)
        with open(trace) as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(sorted({int(row["line"]) for row in rows}), [2, 3, 5, 7, 8, 10, 11, 12])
        self.assertEqual(sum(row["line"] == "5" and row["limit"] == "rest" for row in rows), 1000)
        self.assertEqual(report["speed_limits_of_lines"][0]["limits"]["rest"]["time_s"], 1.0)

    def test_leaves_trace_and_report_as_they_are_where_it_is_not_asked_for(self):
        trace = self.path("out.csv")
        done = self.kerf("dry-run", self.path("a.ngc", self.PROGRAM), "--json", "--trace", trace)
        self.assertNotIn("speed_limits", json.loads(done.stdout))
        with open(trace) as file:
            self.assertNotIn("limit", next(csv.reader(file)))


if __name__ == "__main__":
    main()
