#!/usr/bin/env python3
"""A run from its record, as its users meet it: TEST.py KERF SOURCE_DIR [NAME...]"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import Case, SOURCE, main  # noqa: E402

CIRCLE = f"{SOURCE}/programs/circle.ngc"


class Records(Case):
    def record(self, command, program, *options):
        record = self.path(f"{command}.rec")
        self.kerf(command, "-q", program, "--record", record, *options)
        return pathlib.Path(record).read_bytes()

    def test_a_run_is_repeated_from_its_record_to_the_last_bit(self):
        for program in (CIRCLE, f"{SOURCE}/programs/trident7.ngc"):
            with self.subTest(program=program):
                first = self.record("run", program)
                self.kerf("run", "-q", program, "--replay", self.path("run.rec"), "--record", self.path("again.rec"))
                self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), first)

    def test_a_dry_run_has_the_record_of_the_run(self):
        self.assertEqual(self.record("dry-run", CIRCLE), self.record("run", CIRCLE))

    def test_row_71_a_machine_that_answers_another_run_is_a_fault_at_its_line(self):
        self.record("dry-run", CIRCLE)
        other = self.path("other.ngc", pathlib.Path(CIRCLE).read_text().replace("F", "F1"))
        done = self.kerf("run", other, "--replay", self.path("dry-run.rec"), status=4)
        self.assertRegex(done.stderr, r"machine fault: the run is another one than that of the record, in line \d+, at 0:00:00\.")

    def test_what_is_no_record_is_refused_before_anything_moves(self):
        for text in ("", "G21\n", "KERFREC1" * 100):
            with self.subTest(text=text[:8]):
                done = self.kerf("run", CIRCLE, "--replay", self.path("no.rec", text), "--trace", self.path("t.csv"), status=5)
                self.assertIn("no.rec: ", done.stderr)
                self.assertFalse(pathlib.Path(self.path("t.csv")).exists())

    def test_a_full_disk_does_not_stop_the_run(self):
        done = self.kerf("run", CIRCLE, "--record", "/dev/full", "--trace", self.path("t.csv"), status=5)
        self.assertIn("No space left on device; the record is incomplete", done.stderr)
        self.kerf("dry-run", CIRCLE, "--trace", self.path("d.csv"))
        self.assertEqual(pathlib.Path(self.path("t.csv")).read_text(), pathlib.Path(self.path("d.csv")).read_text())


if __name__ == "__main__":
    main()
