#!/usr/bin/env python3
"""Faults between a run and the next one that goes on from it; the rows are those of README.md: TEST.py KERF SOURCE_DIR [NAME...]"""
import pathlib
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import Case, KERF, main  # noqa: E402

# 12 s, a line every 0.5 s or so.
PART = "G21 G90 G61 F3000\n" + "".join(f"G1 X{20 * (k % 2)} Y{k}\n" for k in range(24)) + "M2\n"


class RestartFaults(Case):
    def setUp(self):
        super().setUp()
        self.program = self.path("part.ngc", PART)
        self.journal = pathlib.Path(self.program + ".journal")

    def start(self, after_s=1.5):
        process = subprocess.Popen([KERF, "run", self.program, "--journal", str(self.journal), "-q"], stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 60
        while not (self.journal.exists() and '"place"' in self.journal.read_text()):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)
        time.sleep(after_s)
        return process

    def lose_power(self):
        process = self.start()
        process.kill()
        self.assertEqual(process.wait(), -signal.SIGKILL)

    def test_row_61_a_program_edited_between_the_runs_does_not_go_on(self):
        self.lose_power()
        self.path("part.ngc", PART.replace("Y20", "Y200"))
        stderr = self.kerf("run", self.program, "--continue", "--yes", status=1).stderr
        self.assertIn("is not the program", stderr)
        self.path("part.ngc", PART)
        self.assertIn("started at", self.kerf("run", self.program, "--continue", "--yes").stdout)

    def test_row_61_a_program_deleted_in_its_run_runs_to_its_end(self):
        process = self.start(after_s=0.0)
        pathlib.Path(self.program).unlink()
        self.assertEqual(process.wait(timeout=60), 0)

    def test_row_77_after_a_kill_the_next_run_says_that_the_last_was_not_ended(self):
        self.lose_power()
        stdout = self.kerf("run", self.program, "--journal", str(self.journal)).stdout
        self.assertIn("was not brought to an end", stdout)
        self.assertNotIn("was not brought to an end", self.kerf("run", self.program, "--journal", str(self.journal)).stdout)

    def test_row_79_a_journal_torn_within_a_record_goes_on_from_the_record_before(self):
        self.lose_power()
        whole = self.journal.read_bytes()
        records = whole.splitlines(keepends=True)
        self.assertGreaterEqual(len(records), 3)
        proposed = []
        for text in (b"".join(records[:-1]), b"".join(records[:-1]) + records[-1][:-1], whole[:-3]):
            self.journal.write_bytes(text)
            proposed.append(self.kerf("run", self.program, "--continue", status=2).stderr.splitlines()[0])
        self.assertEqual(len(set(proposed)), 1)
        self.journal.write_bytes(records[0][:-1])
        self.assertIn("no run is in it", self.kerf("run", self.program, "--continue", status=5).stderr)

    def test_a_restart_leaves_the_drives_where_nobody_confirms_it(self):
        self.lose_power()
        before = self.journal.read_bytes()
        done = self.kerf("run", self.program, "--continue", "--trace", self.path("t.csv"), status=2)
        self.assertIn("nobody is there to confirm", done.stderr)
        self.assertFalse(pathlib.Path(self.path("t.csv")).exists())
        self.assertEqual(self.journal.read_bytes(), before)


if __name__ == "__main__":
    main(at_once=2)
