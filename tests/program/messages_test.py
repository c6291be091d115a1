#!/usr/bin/env python3
"""What `kerf` says of wrong programs, files and words, in each format, and its exit status."""
import csv
import json
import os
import pathlib
import subprocess
import time

from command_line import Case, KERF, SOURCE, LONG, SQUARE, TOO_FAR, WRONG, main


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
        # Longer than a machine file may be; cut off within a number it would be another length.
        long = "T1 Z3\n" + ";" + "-" * (1 << 21) + "\nT7 Z30\n"
        self.assertIn("z 0.000 to 31.000 mm", self.kerf("check", program, "--tools", self.path("long.tbl", long)).stdout)
        missing = self.kerf("check", program, "--tools", self.path("none.tbl"), status=5)
        self.assertIn("none.tbl: error: ", missing.stderr)

    def test_a_program_beyond_the_travel_is_4_and_names_the_line(self):
        done = self.kerf("dry-run", self.path("far.ngc", TOO_FAR), status=4)
        self.assertRegex(done.stderr, r"far\.ngc:3:\d+: error: .*x.*limit")
        self.assertRegex(done.stdout, r"far\.ngc: does not fit\n +x +0\.000 to 1000\.000 mm, over by 500\.000 mm; travel -500 to 500 mm\n")

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

    def test_a_full_disk_is_5_and_the_motion_of_a_run_goes_on(self):
        square = self.path("square.ngc", SQUARE)
        for command, option in (("dry-run", "--plot"), ("run", "--trace"), ("run", "--plot")):
            with self.subTest(command=command, option=option):
                done = self.kerf(command, square, option, "/dev/full", status=5)
                self.assertIn("No space left on device", done.stderr)
                self.assertIn("path            80.000 mm", done.stdout)

    def test_a_dry_run_ends_where_its_trace_does(self):
        done = self.kerf("dry-run", self.path("long.ngc", LONG), "--trace", "/dev/full", status=5)
        self.assertRegex(done.stderr, r"/dev/full: No space left on device, in line \d+; the trace is incomplete")
        self.assertRegex(done.stdout, r"long\.ngc: input or output failed\n  cycle time      0:00:0\d\.")  # of 2000 s

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
    def test_of_the_syntax_reads_the_text_alone(self):
        far = self.path("far.ngc", "G21 G90\nG1 X100000 F3000\nM2\n")
        done = self.kerf("check", "--syntax", far)
        self.assertRegex(done.stdout, r"far\.ngc: ok, the text alone\n$")
        self.kerf("check", far, status=4)
        self.kerf("check", "--syntax", self.path("wrong.ngc", "G1 X@ F1\n"), status=1)
        self.kerf("dry-run", "--syntax", far, status=2)

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


if __name__ == "__main__":
    main()
