#!/usr/bin/env python3
"""Runs by the clock, late ticks and what a tick costs: TEST.py KERF SOURCE_DIR [NAME...]"""
import csv
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import Case, KERF, SQUARE, main  # noqa: E402
from control_channel import connect  # noqa: E402

WAY = "G21 G90 G61\nF1200\nG1 X200\nM30\n"  # 10 s
MACHINE = """[path]
max_velocity_mm_s = 100
max_acceleration_mm_s2 = 1000
max_jerk_mm_s3 = 20000
[driver]
max_late_periods = 20
"""


class RealTime(Case):
    def run_and_suspend(self, pause_s, *options):
        """A run whose process is stopped in motion for a while; its ticks as (t, x)."""
        program, trace = self.path("way.ngc", WAY), self.path("way.csv")
        process = subprocess.Popen([KERF, "run", program, "--trace", trace, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        time.sleep(1.5)
        process.send_signal(signal.SIGSTOP)
        time.sleep(pause_s)
        process.send_signal(signal.SIGCONT)
        out, err = process.communicate(timeout=60)
        with open(trace) as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return process.returncode, out + err, rows

    def test_row_70_a_tick_that_is_far_too_late_stops_the_motion_on_the_path(self):
        status, text, rows = self.run_and_suspend(0.12, "--machine", self.path("m.toml", MACHINE))
        self.assertEqual(status, 4, text)
        self.assertRegex(text, r"machine fault: a tick came 0\.\d+ s late; stopped on the path, from line 3")
        position = [float(row["x_mm"]) for row in rows]
        self.assertLess(position[-1], 199.0)
        self.assertLess(abs(position[-1] - position[-2]), 1e-6)  # at rest
        # No tick is repeated or left out, and none is farther from its neighbours than the feedrate, acceleration and jerk allow.
        steps = [b - a for a, b in zip(position, position[1:])]
        self.assertLessEqual(max(steps), 20.0 * 0.001 * 1.0001)
        self.assertLessEqual(max(abs(b - a) for a, b in zip(steps, steps[1:])), 1000 * 1e-6 * 1.01)
        ticks = [round(float(row["t_s"]) / 0.001) for row in rows]
        self.assertEqual(ticks, list(range(ticks[0], ticks[0] + len(ticks))))

    def test_row_70_without_a_bound_late_ticks_are_counted_and_the_motion_goes_on(self):
        status, text, rows = self.run_and_suspend(0.12)
        self.assertEqual(status, 0, text)
        late = re.search(r"(\d+) ticks late by a period or more", text)
        self.assertTrue(late, text)
        self.assertGreaterEqual(int(late[1]), 1)
        ticks = [round(float(row["t_s"]) / 0.001) for row in rows]
        self.assertEqual(ticks, list(range(len(ticks))))  # none left out, none twice

    def test_each_tick_is_in_the_histogram_of_its_lateness(self):
        square = self.path("square.ngc", SQUARE)
        report = json.loads(self.kerf("run", "--json", square).stdout)
        self.assertEqual(sum(step["ticks"] for step in report["delays"]), sum(1 for _ in range(report["ticks"] + 1)))
        self.assertGreater(report["tick_times"]["worst_s"], 0)
        self.assertGreaterEqual(report["tick_times"]["worst_s"], report["tick_times"]["most_s"])

    def test_row_74_no_tick_for_long_is_a_fault(self):
        status, text, _ = self.run_and_suspend(0.6)
        self.assertEqual(status, 4, text)
        self.assertRegex(text, r"machine fault: no tick for 0\.\d+ s")

    def test_row_74_a_client_hears_of_the_fault(self):
        place = self.path("kerf.sock")
        process = subprocess.Popen([KERF, "run", self.path("way.ngc", WAY), "--control", place], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        client = connect(self, process, place)
        client.read_until(type="event", state="running")
        process.send_signal(signal.SIGSTOP)
        time.sleep(0.7)
        process.send_signal(signal.SIGCONT)
        client.read_until(type="event", state="fault")
        self.assertEqual(client.read_until(type="end")["exit_status"], 4)
        process.communicate(timeout=60)

    def test_what_is_not_permitted_is_told_and_the_run_goes_on(self):
        def unprivileged():
            resource.setrlimit(resource.RLIMIT_RTPRIO, (0, 0))
            resource.setrlimit(resource.RLIMIT_MEMLOCK, (0, 0))
            if os.getuid() == 0:
                os.setgroups([])
                os.setgid(65534)
                os.setuid(65534)
        square = self.path("square.ngc", SQUARE)
        self.folder.chmod(0o755)
        done = subprocess.run([KERF, "run", square, "--realtime"], capture_output=True, text=True, timeout=60, preexec_fn=unprivileged)
        # A busy computer may keep the thread waiting for 10 periods, which is then the fault that it is to be.
        self.assertIn(done.returncode, (0, 4), done.stderr)
        self.assertIn("not in real time: SCHED_FIFO: Operation not permitted", done.stdout)
        self.assertIn("not in real time: locked memory: Operation not permitted", done.stdout)

    def test_real_time_is_what_the_thread_gets_where_it_is_permitted(self):
        long = self.path("way.ngc", WAY)
        process = subprocess.Popen([KERF, "run", long, "--realtime"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.kill)
        def policies_now():
            return {thread: os.sched_getscheduler(int(thread)) & ~os.SCHED_RESET_ON_FORK for thread in os.listdir(f"/proc/{process.pid}/task")}
        # On a busy computer a program begins late.
        policies = policies_now()
        end = time.monotonic() + 8
        while policies[str(process.pid)] != os.SCHED_FIFO and time.monotonic() < end:
            time.sleep(0.1)
            policies = policies_now()
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
        if "SCHED_FIFO" in out:
            self.skipTest("SCHED_FIFO is not permitted")
        self.assertEqual(policies.pop(str(process.pid)), os.SCHED_FIFO)
        self.assertNotIn(os.SCHED_FIFO, policies.values())

    def test_tick_cost_says_what_a_tick_takes_and_which_period_it_bears(self):
        cost = json.loads(self.kerf("tick-cost", "--time", "1", "--json").stdout)
        self.assertGreaterEqual(cost["ticks"], 1000)
        self.assertEqual(cost["period_s"], 0.001)
        for times in (cost["tick_times"], cost["delays"]):
            self.assertLessEqual(times["mean_s"], times["worst_s"])
            self.assertLessEqual(times["most_s"], times["worst_s"])
        needed = cost["tick_times"]["worst_s"] + cost["delays"]["worst_s"]
        if cost["shortest_period_s"] is not None:
            self.assertGreaterEqual(cost["shortest_period_s"], needed)
            self.assertLess(cost["shortest_period_s"], max(2.6 * needed, 2e-5))
        text = self.kerf("tick-cost", "--time", "1s", "--realtime").stdout
        self.assertRegex(text, r"each took +mean [\d.]+ us, 99\.9 % up to [\d.]+ us, the worst [\d.]+ us")

    def test_tick_cost_refuses_a_machine_without_room(self):
        machine = self.path("small.toml", MACHINE + "[axes.x]\nmin_mm = -1\nmax_mm = 1\n")
        self.assertIn("no room", self.kerf("tick-cost", "--time", "1", "--machine", machine, status=4).stderr)


if __name__ == "__main__":
    main()
