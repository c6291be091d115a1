#!/usr/bin/env python3
"""A person at the terminal of `kerf run`: its keys, what they do to the motion, and the terminal afterwards."""
import csv
import os
import pty
import signal
import subprocess
import termios
import time

from command_line import Case, KERF, main

LINE = "G21 G90\nG1 X400 F6000\nM2\n"  # 4 s at 100 mm/s


class Keys(Case):
    def start(self, program=LINE):
        """`kerf run` on a terminal of its own, once it moves."""
        terminal, end = pty.openpty()
        self.addCleanup(os.close, terminal)
        self.before = termios.tcgetattr(end)
        self.end = end
        self.addCleanup(os.close, end)
        self.trace = self.path("run.csv")
        part = self.path("part.ngc", program)
        process = subprocess.Popen([KERF, "run", part, "--trace", self.trace], stdin=end, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   start_new_session=True, preexec_fn=lambda: os.close(os.open(os.ttyname(0), os.O_RDWR)))
        self.addCleanup(process.kill)
        deadline = time.monotonic() + 60
        while termios.tcgetattr(end)[3] == self.before[3] and time.monotonic() < deadline:
            time.sleep(0.01)
        time.sleep(0.5)
        self.terminal = terminal
        return process

    def press(self, key):
        os.write(self.terminal, key)

    def finish(self, process, status):
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, status)
        self.assertEqual(termios.tcgetattr(self.end)[3], self.before[3], "the terminal is as it was")
        with open(self.trace, encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return [float(row[next(name for name in row if name.startswith("x"))]) for row in rows]

    def test_q_stops_on_the_path(self):
        process = self.start()
        self.press(b"q")
        x = self.finish(process, 7)
        self.assertLess(x[-1], 400.0)

    def test_escape_is_the_emergency_stop(self):
        process = self.start()
        self.press(b"\x1b")
        x = self.finish(process, 8)
        self.assertLess(x[-1], 400.0)

    def test_escape_is_the_emergency_stop_whatever_comes_with_it(self):
        for keys in (b"\x1b\x1b", b"\x1bq", b"\x1b ", b" \x1b", b"\x1b[A\x1b"):
            with self.subTest(keys=keys):
                process = self.start()
                self.press(keys)
                x = self.finish(process, 8)
                self.assertLess(x[-1], 400.0)

    def test_an_arrow_behind_a_key_is_none(self):
        process = self.start("G21 G90\nG1 X50 F6000\nM2\n")
        self.press(b"+\x1b[A\x1b[1;5C\x1bOP")
        self.assertEqual(self.finish(process, 0)[-1], 50.0)

    def test_an_arrow_is_none(self):
        process = self.start()
        self.press(b"\x1b[A")
        time.sleep(0.3)
        self.press(b"q")
        self.finish(process, 7)

    def test_space_holds_and_resumes(self):
        process = self.start()
        self.press(b" ")
        time.sleep(1.0)
        self.press(b" ")
        x = self.finish(process, 0)
        self.assertEqual(x[-1], 400.0)
        longest = run = 0
        for before, after in zip(x, x[1:]):
            run = run + 1 if after == before and 0.0 < after < 400.0 else 0
            longest = max(longest, run)
        self.assertGreater(longest, 300, "ticks at rest in the middle")

    def test_minus_and_plus_change_the_feed(self):
        process = self.start()
        for _ in range(5):
            self.press(b"-")
        time.sleep(1.0)
        for _ in range(5):
            self.press(b"+")
        x = self.finish(process, 0)
        self.assertEqual(x[-1], 400.0)
        steps = [after - before for before, after in zip(x, x[1:])]
        slow = sum(1 for step in steps if abs(step - 0.05) < 0.001)
        fast = sum(1 for step in steps if abs(step - 0.1) < 0.001)
        self.assertGreater(slow, 300, "ticks at 50 %")
        self.assertGreater(fast, 1000, "ticks at 100 %")

    def test_s_rests_behind_each_block(self):
        process = self.start("G21 G90 G61\nG1 X100 F6000\nX102\nX104\nM2\n")
        self.press(b"s")
        for _ in range(3):
            time.sleep(1.5)
            self.assertIsNone(process.poll())
            self.press(b"\n")
        x = self.finish(process, 0)
        self.assertEqual(x[-1], 104.0)
        for joint in (100.0, 102.0, 104.0):
            self.assertGreater(x.count(joint), 300, "ticks at rest at the joint")

    def test_enter_answers_a_program_stop(self):
        process = self.start("G21 G90\nG1 X10 F6000\nM0\nX20\nM2\n")
        time.sleep(0.5)
        self.assertIsNone(process.poll())
        self.press(b"\n")
        self.assertEqual(self.finish(process, 0)[-1], 20.0)

    def test_a_second_interrupt_is_the_emergency_stop(self):
        process = self.start()
        process.send_signal(signal.SIGINT)
        time.sleep(0.03)
        process.send_signal(signal.SIGINT)
        x = self.finish(process, 8)
        self.assertLess(x[-1], 400.0)


if __name__ == "__main__":
    main(at_once=2)
