#!/usr/bin/env python3
"""A run from its record, as its users meet it: TEST.py KERF SOURCE_DIR [NAME...]"""
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import SOURCE, main  # noqa: E402
from control_channel import ControlCase  # noqa: E402

CIRCLE = f"{SOURCE}/programs/circle.ngc"


class Records(ControlCase):
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

    def repeat(self, status):
        """Twice, with and without a clock of its own: each has the record of the first, to the last byte."""
        first = pathlib.Path(self.path("run.rec")).read_bytes()
        for command in ("dry-run", "run"):
            with self.subTest(command=command):
                self.kerf(command, "-q", self.path("part.ngc"), "--replay", self.path("run.rec"), "--record", self.path("again.rec"), status=status)
                self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), first)

    def test_a_run_under_commands_is_repeated_from_its_record_to_the_last_bit(self):
        process, client = self.start("G21 G90 G61\nG1 X60 F6000\nG2 X80 Y20 R20\n(a blend)\nG64 P0.1\nG1 Y40\nX40\nM0\nX20\nM2\n",
                                     ["--record", self.path("run.rec"), "-q"])
        client.ask("override", feed_percent=70.3)
        time.sleep(0.2)
        client.ask("hold")
        client.read_until(type="event", state="held")
        self.assertTrue(client.ask("jog", z_mm=2)["accepted"])
        client.read_until(type="event", state="held")
        self.assertFalse(client.ask("start")["accepted"])
        client.ask("resume")
        client.read_until(type="event", state="running")
        client.ask("override", feed_percent=0)
        client.ask("override", feed_percent=120, rapid_percent=50)
        client.read_until(type="event", state="waiting", waits_for="answer")
        client.ask("single_block", on=True)
        client.ask("resume")
        client.read_until(type="event", state="waiting", waits_for="answer")
        client.ask("resume")
        self.end(process, 0)
        self.repeat(0)

    def test_a_run_that_begins_with_lines_and_is_stopped_is_repeated(self):
        process, client = self.start(options=["--record", self.path("run.rec"), "-q", "--wait-start"])
        client.read_until(type="event", state="idle")
        self.assertTrue(client.ask("mdi", line="G10 L2 P1 X5")["accepted"])
        client.read_until(type="event", state="idle")
        self.assertTrue(client.ask("start")["accepted"])
        time.sleep(0.3)
        client.ask("stop")
        self.end(process, 7)
        self.repeat(7)

    def test_a_start_in_the_middle_that_was_confirmed_by_a_client_is_repeated(self):
        text = "G21 G90 G61 F6000\n" + "".join(f"G1 X{10 * i}\n" for i in range(1, 8)) + "M2\n"
        process, client = self.start(text, ["--from-line", "5", "--record", self.path("run.rec"), "-q"])
        client.read_until(type="event", state="waiting")
        self.assertTrue(client.ask("resume")["accepted"])
        self.end(process, 0)
        first = pathlib.Path(self.path("run.rec")).read_bytes()
        for command in ("dry-run", "run"):
            self.kerf(command, "-q", self.path("part.ngc"), "--from-line", "5", "--replay", self.path("run.rec"), "--record", self.path("again.rec"))
            self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), first)

    def test_an_emergency_stop_is_repeated_at_its_tick(self):
        process, client = self.start(options=["--record", self.path("run.rec"), "-q"])
        time.sleep(0.3)
        client.ask("emergency_stop")
        self.end(process, 8)
        self.repeat(8)

    def test_a_longer_program_than_that_of_a_record_with_commands_is_another_run(self):
        process, client = self.start(options=["--record", self.path("run.rec"), "-q"])
        client.ask("hold")
        client.read_until(type="event", state="held")
        client.ask("resume")
        self.end(process, 0)
        longer = self.path("longer.ngc", pathlib.Path(self.path("part.ngc")).read_text().replace("M2", "X300\nX350\n" * 1500 + "M2"))
        for command in ("run", "dry-run"):
            done = self.kerf(command, "-q", longer, "--replay", self.path("run.rec"), status=4)
            self.assertIn("another one than that of the record", done.stderr)

    def test_a_run_that_is_refused_leaves_an_older_record(self):
        first = self.record("dry-run", CIRCLE)
        self.kerf("dry-run", CIRCLE, "--record", self.path("dry-run.rec"), "--trace", "/nowhere/t.csv", status=5)
        self.assertEqual(pathlib.Path(self.path("dry-run.rec")).read_bytes(), first)
        self.assertFalse(pathlib.Path(self.path("dry-run.rec.incomplete")).exists())

    def test_a_record_with_commands_takes_no_others(self):
        process, client = self.start(options=["--record", self.path("run.rec"), "-q"])
        client.ask("stop")
        self.end(process, 7)
        done = self.kerf("run", self.path("part.ngc"), "--replay", self.path("run.rec"), "--control", self.path("socket"), status=2)
        self.assertIn("it goes without --control", done.stderr)

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
