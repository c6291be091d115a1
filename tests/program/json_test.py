#!/usr/bin/env python3
"""The JSON report: its keys, what it tells of a run, a check, several files and errors."""
import json
import os
import pathlib

from command_line import Case, SOURCE, SQUARE, WRONG, main


class Json(Case):
    KEYS = ("schema_version", "file", "command", "exit_status", "machine", "profile", "feed_override", "period_s", "path_boxes", "fit", "cycle_time_s", "ticks",
            "path_length_mm", "blocks", "extents", "path_modes", "waits", "deviation", "time_split", "time_by_tool", "time_by_operation", "approach", "max", "limits_exceeded", "chord_error_mm", "contour_error",
            "following_error", "starved_ticks", "warnings", "errors", "elapsed")

    def test_a_feed_override_is_what_an_operator_would_make_of_the_feedrate(self):
        program = self.path("line.ngc", "G21 G90 G61\nG1 F600 X100\nG0 X0\nM2\n")
        machine = self.path("slow.toml", "[path]\nmax_velocity_mm_s = 15\nmax_acceleration_mm_s2 = 100\nmax_jerk_mm_s3 = 1000\n")
        for profile in ("s-curve", "time-optimal"):
            # A ramp to v with acceleration a and jerk j takes v / a + a / j, or 2 sqrt(v / j) below a^2 / j = 10 mm/s; there and back half of it
            # is lost against v. The rapid is the machine's.
            def time_s(v):
                return 100.0 / v + (v / 100.0 + 0.1 if v >= 10.0 else 2.0 * (v / 1000.0) ** 0.5)
            for percent, v in ((50, 5.0), (100, 10.0), (120, 12.0), (200, 15.0)):
                report = json.loads(self.kerf("dry-run", program, "--machine", machine, "--profile", profile, "--feed-override", str(percent), "--json").stdout)
                self.assertEqual(report["feed_override"], percent / 100)
                self.assertEqual(report["profile"], profile)
                self.assertAlmostEqual(report["cycle_time_s"], time_s(v) + time_s(15.0), delta=0.003)
        self.assertIn("  feed override   80 %\n", self.kerf("dry-run", program, "--feed-override", "80").stdout)
        for wrong in ("0", "201", "nan", "-5"):
            self.assertIn("--feed-override: 1 to 200 percent", self.kerf("dry-run", program, f"--feed-override={wrong}", status=2).stderr)

    def test_a_check_rests_for_answers_of_the_machine_as_a_dry_run_does(self):
        limits = "[path]\nmax_velocity_mm_s = 250\nmax_acceleration_mm_s2 = 2500\nmax_jerk_mm_s3 = 50000\n"
        inputs = self.path("inputs.toml", limits + "[simulation]\ndigital = [3]\n")
        spindle = self.path("spindle.toml", limits + "[program]\nwaits_for_spindle = true\n")
        slow = self.path("slow.toml", limits + "[program]\nwaits_for_spindle = true\nspindle_start_s = 1\n[simulation]\nspindle_per_min_s = 1000\n")
        for machine, asks in ((inputs, ("M66 P3 L3 Q5", "M66 P3 L0", "M66 P4 L0", "M66 P4 L3 Q0.5", "M66 E0 L0")), (spindle, ("S1000 M3", "S1000 M3\nS500")),
                              (slow, ("S500 M3", "S1000 M3", "S3000 M4", "S2000 M3\nS1000", "S1000 M3\nG4 P2\nM5"))):
            for ask in asks:
                part = self.path("asks.ngc", f"G21 G90 F6000\nG1 X10\n{ask}\nG1 X10 Y10\nM2\n")
                checked, ran = (json.loads(self.kerf(command, part, "--machine", machine, "--json").stdout) for command in ("check", "dry-run"))
                with self.subTest(ask=ask):
                    self.assertEqual(checked["ticks"], ran["ticks"])
                    self.assertEqual(checked["deviation"], ran["deviation"])  # no blend where the tool rests
                    self.assertEqual(checked["blocks"], ran["blocks"])

    def test_lists_where_a_program_waits_and_the_time_that_the_machine_file_gives_it(self):
        part = self.path("waits.ngc", "G21 G90 G61 F6000\nG1 X10\nM3 S1000\nM1\nM0\nS2000\nM5\nM4\nT2 M6\nM60\nG1 X0\nM2\n")
        plain = json.loads(self.kerf("dry-run", part, "--json").stdout)
        self.assertEqual(plain["waits"], {"count": 3, "duration_s": 0, "first": [
            {"line": 5, "kind": "program_stop", "duration_s": 0}, {"line": 9, "kind": "tool_change", "duration_s": 0, "tool": 2},
            {"line": 10, "kind": "pallet_change", "duration_s": 0}]})
        slow = self.path("slow.toml", (pathlib.Path(SOURCE) / "programs/machines/sigmoid-butterfly.toml").read_text())
        base = json.loads(self.kerf("dry-run", part, "--machine", slow, "--json").stdout)["cycle_time_s"]
        with open(slow, "a", encoding="utf-8") as file:
            file.write("\n[program]\ntool_change_s = 7.5\nspindle_start_s = 2\n")
        report = json.loads(self.kerf("dry-run", part, "--machine", slow, "--json").stdout)
        self.assertEqual([(wait["line"], wait["kind"], wait["duration_s"]) for wait in report["waits"]["first"]],
                         [(3, "spindle_start", 2), (5, "program_stop", 0), (8, "spindle_start", 2), (9, "tool_change", 7.5), (10, "pallet_change", 0)])
        self.assertEqual(report["waits"]["duration_s"], 11.5)
        self.assertAlmostEqual(report["cycle_time_s"] - base, 11.5, delta=0.003)
        split = report["time_split"]
        self.assertAlmostEqual(split["tool_change_s"], 7.5, delta=0.0021)
        self.assertAlmostEqual(split["rest_s"], 4.0, delta=0.0081)
        self.assertAlmostEqual(sum(split.values()), report["cycle_time_s"], places=9)
        by_tool = {part.pop("tool"): part for part in report["time_by_tool"]}
        self.assertEqual(list(by_tool), ["no tool", "T2"])
        for key, seconds in split.items():
            self.assertAlmostEqual(sum(part[key] for part in by_tool.values()), seconds, places=9)
        self.assertEqual(json.loads(self.kerf("check", part, "--machine", slow, "--json").stdout)["waits"], report["waits"])
        tapping = self.path("tapping.ngc", "G21 G90 G0 Z5\nM3 S500\nG84 X1 Y1 Z-5 R1 F500\nG86 X3 Y1 Z-5 R1 P0 F500\nM5\nM2\n")
        report = json.loads(self.kerf("dry-run", tapping, "--machine", slow, "--json").stdout)
        self.assertEqual([wait["line"] for wait in report["waits"]["first"]], [2, 4])
        self.assertIn("waits           spindle start in line 3 (2 s), M0 in line 5, spindle start in line 8 (2 s), M6 to T2 in line 9 (7.5 s), M60 in line 10; "
                      "11.5 s of the cycle time", self.kerf("dry-run", part, "--machine", slow).stdout)

    def test_parts_the_time_by_operation_as_the_comments_name_them(self):
        part = self.path("operations.ngc", "G21 G90 G61 F600\nG0 Z5\n(rough)\nG1 X10\nN40 ; finish\n(MSG, no heading)\nG1 X15\nG4 P2\nG0 X0\nM2\n")
        report = json.loads(self.kerf("dry-run", part, "--json").stdout)
        rough, finish = report["time_by_operation"][1:]
        self.assertEqual([(rough["operation"], rough["line"]), (finish["operation"], finish["line"])], [("rough", 3), ("finish", 5)])
        self.assertNotIn("line", report["time_by_operation"][0])
        self.assertAlmostEqual(rough["cutting_s"], 1.0, delta=0.1)
        self.assertAlmostEqual(finish["cutting_s"], 0.5, delta=0.1)
        self.assertAlmostEqual(finish["rest_s"], 2.0, delta=0.003)
        for key, seconds in report["time_split"].items():
            self.assertAlmostEqual(sum(one[key] for one in report["time_by_operation"]), seconds, places=9)
        lines = self.kerf("dry-run", part).stdout.splitlines()
        at = next(i for i, line in enumerate(lines) if line.startswith("  by operation"))
        self.assertRegex(lines[at], r"^  by operation    0:00:00\.\d{3}  before the first heading$")
        self.assertRegex(lines[at + 2], r"^                  0:00:0[23]\.\d{3}  finish: cutting 0:00:00\.\d{3}, rapid 0:00:00\.\d{3}, rest 0:00:0[12]\.\d{3}$")

    def test_names_the_path_modes_that_ran_and_who_named_them(self):
        text = "G21 G90 F3000\nG1 X20\nY20\nG61\nX0\nG61.1\nY0\nM2\n"
        done = self.kerf("dry-run", self.path("modes.ngc", text))
        self.assertIn("  path mode       G64 of the machine, P 0.01, Q 0.01 mm; then G61 of the program; then G61.1 of the program\n",
                      done.stdout)
        report = json.loads(self.kerf("dry-run", "--json", self.path("modes.ngc", text)).stdout)
        self.assertEqual(report["path_modes"], [
            {"mode": "G64", "by": "machine", "corner_tolerance_mm": 0.01, "merge_tolerance_mm": 0.01},
            {"mode": "G61", "by": "program"}, {"mode": "G61.1", "by": "program"}])
        self.assertLessEqual(report["deviation"]["max_mm"], 0.01)
        exact = self.path("exact.toml", "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 3000\nmax_jerk_mm_s3 = 55_000\n"
                                        "[program]\npath_mode = 'G61'\n")
        report = json.loads(self.kerf("dry-run", "--json", "--machine", exact, self.path("modes.ngc", text)).stdout)
        self.assertEqual(report["path_modes"][0], {"mode": "G61", "by": "machine"})
        # A canned cycle and a probe run on the exact path in every mode: they name none.
        program = self.path("drill.ngc", "G21 G90 F600 S1000 M3\nG0 X10 Z5\nG81 X20 Z-2 R2\nG80\nG38.3 Z3\nG1 X30\nM2\n")
        modes = json.loads(self.kerf("dry-run", program, "--json").stdout)["path_modes"]
        self.assertEqual([mode["mode"] for mode in modes], ["G64"])
        self.assertEqual(report["deviation"]["max_mm"], 0.0)

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

    def test_names_the_file_of_a_subprogram_that_is_wrong(self):
        self.path("wrong_sub.ngc", "o<wrong_sub> sub\nG1 X5 D3\no<wrong_sub> endsub\nM2\n")
        report = json.loads(self.kerf("check", "--json", self.path("main.ngc", "G21 G90\nG0 X1\no<wrong_sub> call\nM2\n"), status=1).stdout)
        error, = report["errors"]
        self.assertEqual((error["line"], pathlib.Path(error["file"]).name), (2, "wrong_sub.ngc"))
        warning, = [one for one in report["warnings"] if "D3" in one]
        self.assertRegex(warning, r"^line 2 of .*wrong_sub.ngc: ")

    def test_says_by_how_much_a_figure_exceeds_its_limit(self):
        # A law without jerk, on a machine with one.
        program = os.path.join(SOURCE, "programs/circle.ngc")
        done = self.kerf("dry-run", "--json", "--profile", "trapezoid", program)
        report = json.loads(done.stdout)
        jerk = next(e for e in report["limits_exceeded"] if e["where"] == "path" and e["quantity"] == "jerk")
        self.assertAlmostEqual(jerk["ratio"], jerk["value"] / jerk["limit"])
        self.assertGreater(jerk["ratio"], 2)
        self.assertTrue(any("path jerk" in warning for warning in report["warnings"]))
        self.assertIn("kerf: warning: ", done.stderr)

    def test_exceeds_no_limit_on_a_spline(self):
        for profile in ("time-optimal", "s-curve"):
            report = json.loads(self.kerf("dry-run", "--json", "--profile", profile,
                                          os.path.join(SOURCE, "programs/butterfly.ngc")).stdout)
            self.assertEqual(report["limits_exceeded"], [])
            self.assertEqual(report["warnings"], [])


if __name__ == "__main__":
    main()
