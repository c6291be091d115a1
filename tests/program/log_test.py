#!/usr/bin/env python3
"""`--log` and `--log-level`: how the motion is planned, and what cannot be written."""
import os
import pathlib

from command_line import Case, SOURCE, main


class Log(Case):
    PROGRAM = os.path.join(SOURCE, "programs/trident7.ngc")

    def test_of_level_debug_tells_how_the_motion_is_planned(self):
        for profile, words in (("sine", ("scan of", "breaking points", "velocity segments", "segment from s", "end is adjusted")),
                               ("time-optimal", ("scan of", "search over", "Newton steps"))):
            done = self.kerf("dry-run", self.PROGRAM, "--profile", profile, "--log-level", "debug", "--quiet", "--log", self.path("l.log"))
            self.assertEqual(done.stderr, "")
            text = pathlib.Path(self.path("l.log")).read_text()
            for word in words:
                self.assertIn(word, text)
            self.assertTrue(all(" kerf: debug: " in line for line in text.splitlines()))

    def test_goes_to_standard_error_without_a_file(self):
        for command in ("dry-run", "check"):
            self.assertIn("kerf: debug: line 6: scan of 48.99", self.kerf(command, self.PROGRAM, "--log-level", "debug").stderr)
            self.assertEqual(self.kerf(command, self.PROGRAM).stderr, "")

    def test_leaves_the_motion_to_the_bit(self):
        plain, logged = self.path("plain.csv"), self.path("logged.csv")
        self.kerf("dry-run", self.PROGRAM, "--trace", plain)
        self.kerf("dry-run", self.PROGRAM, "--trace", logged, "--log-level", "debug", "--log", self.path("l.log"))
        self.assertEqual(pathlib.Path(plain).read_bytes(), pathlib.Path(logged).read_bytes())

    def test_that_cannot_be_written_ends_the_command_with_5(self):
        for file in (self.path("no/such/folder.log"), self.path("")):
            self.assertIn("kerf: error: ", self.kerf("dry-run", self.PROGRAM, "--log", file, status=5).stderr)

    def test_a_fifo_that_nobody_reads_is_refused_and_one_with_a_reader_gets_the_log(self):
        fifo = self.path("log.fifo")
        os.mkfifo(fifo)
        self.assertIn("nobody reads it", self.kerf("check", self.PROGRAM, "--log", fifo, status=5).stderr)
        with os.fdopen(os.open(fifo, os.O_RDONLY | os.O_NONBLOCK)) as reader:
            self.kerf("check", self.PROGRAM, "--log", fifo, "--log-level", "debug")
            self.assertIn("kerf: debug: ", reader.read())

    def test_on_a_full_disk_ends_the_command_with_5_and_says_so(self):
        done = self.kerf("dry-run", self.PROGRAM, "--log", "/dev/full", "--log-level", "debug", status=5)
        self.assertIn("cycle time", done.stdout)
        self.assertIn("kerf: error: Failed flush to file /dev/full: No space left on device", done.stderr)


if __name__ == "__main__":
    main()
