#!/usr/bin/env python3
"""`kerf run` by the clock: input that is still coming, signals and the progress bar."""
import csv
import fcntl
import json
import os
import pty
import re
import select
import signal
import struct
import subprocess
import termios
import time

from command_line import Case, KERF, LONG, SQUARE, TOO_FAR, main


class LiveInput(Case):
    """`kerf run -` on a pipe: motion begins before the text ends."""

    def start(self, *words):
        child = subprocess.Popen([KERF, "run", "-", "--json", *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        self.addCleanup(child.kill)
        return child

    def finish(self, child, more="", status=0):
        out, err = child.communicate(more, timeout=60)
        self.assertEqual(child.returncode, status, out + err)
        return json.loads(out), err

    def test_moves_while_the_input_is_still_open(self):
        child = self.start()
        child.stdin.write("G21 G90\nF3000\nG1 X10\n")
        child.stdin.flush()
        time.sleep(2.0)
        report, _ = self.finish(child, "G1 X20\nM30\n")
        self.assertEqual(report["extents"]["max_mm"]["x"], 20.0)
        # Had it waited for the end, nothing would have stood still between the two moves.
        waited = [w for w in report["warnings"] if w.startswith("waited for text: ")]
        self.assertEqual(len(waited), 1, report["warnings"])
        self.assertGreater(report["cycle_time_s"], 1.0)

    def test_is_stopped_by_a_request_while_it_waits(self):
        child = self.start()
        child.stdin.write("G21 G90\nG1 X10 F3000\n")
        child.stdin.flush()
        time.sleep(1.5)
        child.send_signal(signal.SIGINT)
        out, err = child.communicate(timeout=30)
        self.assertEqual(child.returncode, 130, out + err)

    def test_stops_at_rest_before_a_wrong_block(self):
        child = self.start()
        report, err = self.finish(child, "G21 G90\nG1 X10 F3000\nG77\nG1 X20\nM30\n", status=1)
        self.assertIn("<stdin>:3:1: error: G77 is not known", err)
        self.assertEqual(report["extents"]["max_mm"]["x"], 10.0)

    def test_stops_at_rest_before_a_block_that_leaves_the_table(self):
        child = self.start()
        report, err = self.finish(child, TOO_FAR, status=4)
        self.assertIn("<stdin>:3:1: error: ", err)
        self.assertEqual(report["extents"]["max_mm"]["x"], 10.0)


class Signals(Case):
    def start(self, *words):
        process = subprocess.Popen([KERF, *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        return process

    def wait_for_rows(self, path, process):
        path += ".incomplete"  # until it is whole
        deadline = time.monotonic() + 60
        while not (os.path.exists(path) and os.path.getsize(path) > 100_000):
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)

    def stopped_run(self, number, status):
        trace = self.path("trace.csv")
        process = self.start("run", self.path("long.ngc", LONG), "--trace", trace)
        self.wait_for_rows(trace, process)
        process.send_signal(number)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, status, err)
        self.assertIn("stopped on the path, as asked for", out)
        with open(trace) as file:
            return list(csv.DictReader(file))

    def test_interrupted_run_comes_to_rest_on_the_path_within_the_limits_and_is_130(self):
        rows = self.stopped_run(signal.SIGINT, 130)
        v = [float(row["v_mm_s"]) for row in rows]
        x = [float(row["x_mm"]) for row in rows]
        self.assertEqual(v[-1], 0.0)
        self.assertGreater(max(v), 9.0)
        self.assertTrue(all(float(row["y_mm"]) == 0.0 for row in rows))
        accelerations = [(a - 2 * b + c) / 1e-6 for a, b, c in zip(x[2:], x[1:], x)]
        self.assertLess(max(map(abs, accelerations)), 2500 * 1.01)
        jerks = [(a - b) / 1e-3 for a, b in zip(accelerations[1:], accelerations)]
        self.assertLess(max(map(abs, jerks)), 50000 * 1.02)

    def test_terminated_run_is_143(self):
        self.stopped_run(signal.SIGTERM, 143)

    def test_hung_up_run_is_129(self):
        self.stopped_run(signal.SIGHUP, 129)

    def test_quit_run_is_130(self):
        self.stopped_run(signal.SIGQUIT, 130)

    def test_a_run_under_nohup_goes_on_when_its_terminal_hangs_up(self):
        process = subprocess.Popen([KERF, "run", self.path("slow.ngc", "G21 G90\nG1 X30 F1200\nM2\n")], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        self.addCleanup(process.kill)
        time.sleep(0.7)
        process.send_signal(signal.SIGHUP)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, err)

    def interrupted_at_once(self, *signals):
        """The exit status and the summary."""
        process = self.start("run", self.path("long.ngc", LONG), "--trace", self.path("trace.csv"))
        self.wait_for_rows(self.path("trace.csv"), process)
        process.send_signal(signal.SIGSTOP)
        for number in signals:  # of different numbers: two pending SIGINT would be one
            process.send_signal(number)
        process.send_signal(signal.SIGCONT)
        out, _ = process.communicate(timeout=60)
        return process.returncode, out

    def test_second_interrupt_is_the_emergency_stop(self):
        status, out = self.interrupted_at_once(signal.SIGINT, signal.SIGTERM)
        self.assertEqual(status, 8)
        self.assertIn("emergency stop", out)

    def test_third_interrupt_ends_at_once(self):
        status, _ = self.interrupted_at_once(signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
        self.assertIn(status, (129, 130, 143))
        self.assertEqual(sorted(os.listdir(self.folder)), ["long.ngc", "trace.csv.incomplete"])

    def test_interrupt_while_waiting_for_input_is_130(self):
        reading, writing = os.pipe()
        process = subprocess.Popen([KERF, "dry-run", "-"], stdin=reading, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(process.kill)
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        os.close(reading), os.close(writing)
        self.assertEqual(process.returncode, 130)

    def test_interrupted_dry_run_is_130_and_prompt(self):
        trace = self.path("trace.csv")
        process = self.start("dry-run", self.path("long.ngc", LONG), "--trace", trace)
        while not os.path.exists(trace + ".incomplete"):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("trace.csv.incomplete", os.listdir(self.folder))  # what was to be shown is not all there
        self.assertNotIn("trace.csv", os.listdir(self.folder))

    def test_closed_standard_output_does_not_stop_a_run(self):
        command = [KERF, "run", self.path("square.ngc", SQUARE), "--trace", "-"]
        reading, writing = os.pipe()
        os.close(reading)
        begin = time.monotonic()
        done = subprocess.run(command, stdout=writing, stderr=subprocess.PIPE, text=True, timeout=60)
        os.close(writing)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("path            80.000 mm", done.stderr)
        self.assertGreater(time.monotonic() - begin, 80 / 50)


class ProgressBar(Case):
    def resize(self, terminal, columns):
        fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))

    def on_a_terminal(self, *words, columns=0):
        """The process, and what its terminal shows, piece by piece. Columns: 0 where it does not know."""
        master, slave = pty.openpty()
        self.resize(slave, columns)
        self.master = master
        process = subprocess.Popen([KERF, *words], stdout=subprocess.PIPE, stderr=slave, env={**os.environ, "TERM": "xterm"})
        self.addCleanup(process.kill)
        self.addCleanup(os.close, master)
        os.close(slave)

        def pieces():
            while select.select([master], [], [], 60)[0]:
                try:
                    piece = os.read(master, 4096)
                except OSError:
                    return
                if not piece:
                    return
                yield piece
        return process, pieces()

    def test_of_a_dry_run_says_how_far_it_is_and_what_is_left(self):
        long = "G21 G90 G61\nF600\n" + "G1 X200\nG1 X0\n" * 1000 + "M30\n"  # 40,000 s, all of them alike
        process, pieces = self.on_a_terminal("dry-run", self.path("long.ngc", long))
        shown = b""
        for piece in pieces:
            shown += piece
            if re.search(rb"[1-9] %, [^\r]* left\r", shown):
                process.send_signal(signal.SIGINT)
                break
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        shares = [int(share) for share in re.findall(rb"(\d+) %", shown)]
        self.assertEqual(shares, sorted(shares))
        self.assertLess(shares[0], 50)

    def test_appears_on_a_terminal_after_a_second_and_goes(self):
        slow = "G21 G90\nF1200\nG1 X50\nM30\n"  # 2.5 s
        process, pieces = self.on_a_terminal("run", self.path("slow.ngc", slow))
        shown = b"".join(pieces)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0)
        self.assertIn(b"running", shown)
        self.assertIn(b" %", shown)
        self.assertTrue(shown.endswith(b"\r\x1b[K"))

    def widths(self, shown):
        lines = [len(line) for line in shown.replace(b"\x1b[K", b"").split(b"\r") if line]
        self.assertGreater(len(lines), 3)
        return lines

    def test_never_fills_a_row_of_the_terminal(self):
        slow = self.path("slow.ngc", "G21 G90\nF1200\nG1 X50\nM30\n")  # 2.5 s
        for columns in (0, 120, 80, 60, 20, 1):
            with self.subTest(columns=columns):
                process, pieces = self.on_a_terminal("run", slow, columns=columns)
                shown = b"".join(pieces)
                process.communicate(timeout=60)
                if columns > 1:  # else nothing has room
                    self.assertIn(b"running", shown)
                    self.assertLess(max(self.widths(shown)), columns or 80)
                self.assertNotIn(b"\n", shown)

    def test_of_a_dry_run_never_fills_a_row_of_the_terminal(self):
        long = self.path("long.ngc", "G21 G90 G61\nF600\n" + "G1 X200\nG1 X0\n" * 1000 + "M30\n")
        process, pieces = self.on_a_terminal("dry-run", long, columns=30)
        shown = b""
        for piece in pieces:
            shown += piece
            if shown.count(b"%") > 8:
                process.send_signal(signal.SIGINT)
                break
        process.communicate(timeout=60)
        self.assertLess(max(self.widths(shown)), 30)

    def test_follows_a_terminal_that_gets_narrower(self):
        slow = self.path("slow.ngc", "G21 G90\nF1200\nG1 X60\nM30\n")  # 3 s
        process, pieces = self.on_a_terminal("run", slow, columns=100)
        shown = next(pieces)
        self.resize(self.master, 40)
        next(pieces)  # may have been written before
        rest = b"".join(pieces)
        process.communicate(timeout=60)
        self.assertGreater(max(len(line) for line in shown.split(b"\r")), 40)
        self.assertLess(max(self.widths(rest)), 40)

    def test_never_appears_in_a_pipe(self):
        slow = "G21 G90\nF1200\nG1 X30\nM30\n"
        self.assertEqual(self.kerf("run", self.path("slow.ngc", slow)).stderr.count("\r"), 0)


if __name__ == "__main__":
    main(at_once=2)
