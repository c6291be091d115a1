#!/usr/bin/env python3
"""A person at the terminal of `kerf run`: its keys, what they do to the motion, and the terminal afterwards."""
import csv
import os
import pty
import re
import select
import signal
import subprocess
import termios
import time

from command_line import Case, KERF, main

LINE = "G21 G90\nG1 X400 F6000\nM2\n"  # 4 s at 100 mm/s


class Keys(Case):
    def start(self, program=LINE, *options, sees=False):
        """`kerf run` on a terminal of its own, once it moves. sees: that shows standard error, too."""
        terminal, end = pty.openpty()
        self.addCleanup(os.close, terminal)
        self.before = termios.tcgetattr(end)
        self.end = end
        self.addCleanup(os.close, end)
        self.trace = self.path("run.csv")
        part = self.path("part.ngc", program)
        process = subprocess.Popen([KERF, "run", part, "--trace", self.trace, *options], stdin=end, stdout=subprocess.PIPE,
                                   stderr=end if sees else subprocess.PIPE, env={**os.environ, "TERM": "xterm"},
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

    def seen(self, wanted):
        """What the terminal shows until it shows that."""
        shown = b""
        deadline = time.monotonic() + 20
        while not re.search(wanted, shown):
            self.assertLess(time.monotonic(), deadline, shown[-1000:])
            if select.select([self.terminal], [], [], 1)[0]:
                shown += os.read(self.terminal, 4096)
        return shown

    def finish(self, process, status):
        _, self.said = process.communicate(timeout=60)
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

    def test_a_key_that_does_nothing_says_why(self):
        process = self.start("G21 G90\nG1 X400 F6000\nM2\n", sees=True)
        self.press(b"\n")
        self.seen(rb"not done: [a-z][^\r\n]*\r?\n")
        self.press(b"X")
        self.seen(rb"not done: [a-z][^\r\n]*\r?\n")
        self.press(b"q")
        self.finish(process, 7)

    def test_what_waits_for_a_person_is_written_once(self):
        waits = ((b"M0", b"an operator (program stop, M0)"), (b"M1", b"an operator (optional stop, M1)"),
                 (b"M60", b"the pallet change (M60)"), (b"T3 M6", b"tool 3 (M6)"))
        program = "".join(f"G21 G90\n{code.decode()}\n" for code, _ in waits) + "G1 X20 F6000\nM2\n"
        for options in ((), ("-q",)):
            with self.subTest(options=options):
                process = self.start(program, "--optional-stop", *options)
                for _ in waits:
                    time.sleep(0.3)
                    self.press(b"\n")
                self.assertEqual(self.finish(process, 0)[-1], 20.0)
                self.assertEqual([line for line in self.said.splitlines() if b"waiting" in line],
                                 [b"waiting at line %d for %s: Enter goes on" % (2 * i + 2, what) for i, (_, what) in enumerate(waits)])

    def test_the_rests_of_single_block_are_written_where_no_status_line_says_it(self):
        process = self.start("G21 G90 G61\nG1 X100 F6000\nX102\nM2\n")
        self.press(b"s")
        for _ in range(2):
            time.sleep(1.5)
            self.press(b"\n")
        self.finish(process, 0)
        self.assertIn(b"waiting at line 2 after a block (single block): Enter goes on\n", self.said)

    def test_a_program_that_waits_for_its_start_says_so(self):
        process = self.start(LINE, "--wait-start", "-q")
        self.press(b"q")
        process.communicate(timeout=60)
        process = self.start("G21 G90\nG1 X10 F6000\nM2\n", "--wait-start", "-q")
        self.press(b"\n")
        self.assertEqual(self.finish(process, 0)[-1], 10.0)
        self.assertEqual(self.said, b"waiting for the start: Enter starts the program\n")

    def test_the_status_line_says_what_it_waits_for(self):
        process = self.start("G21 G90\nG1 X50 F6000\nT3 M6\nX20\nM2\n", sees=True)
        shown = self.seen(rb"waiting   line 3      for tool 3 \(M6\): Enter goes on +100 %")
        self.assertEqual(shown.count(b"waiting at line 3 for tool 3 (M6): Enter goes on\r\n"), 1)
        self.press(b"\n")
        self.finish(process, 0)

    def test_the_status_line_says_that_the_feed_is_0(self):
        process = self.start("G21 G90\nG1 X200 F6000\nM2\n", sees=True)
        self.press(b"-" * 10)
        self.seen(rb"running   line 2      stands: the feed is at 0 % +0 %")
        self.press(b"q")
        self.finish(process, 7)

    def test_a_second_interrupt_is_the_emergency_stop(self):
        process = self.start()
        process.send_signal(signal.SIGINT)
        time.sleep(0.03)
        process.send_signal(signal.SIGINT)
        x = self.finish(process, 8)
        self.assertLess(x[-1], 400.0)

    def test_the_quit_key_stops_as_an_interrupt_does(self):
        process = self.start()
        self.press(b"\x1c")
        x = self.finish(process, 130)
        self.assertLess(x[-1], 400.0)

    def test_the_quit_key_pressed_again_is_the_emergency_stop(self):
        process = self.start()
        self.press(b"\x1c")
        time.sleep(0.03)
        self.press(b"\x1c")
        self.finish(process, 8)


if __name__ == "__main__":
    main(at_once=2)
