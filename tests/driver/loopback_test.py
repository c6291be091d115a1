#!/usr/bin/env python3
"""kerf and the machine in two processes, and what becomes of it when one of them fails: TEST.py KERF SOURCE_DIR [NAME...]"""
import csv
import os
import pathlib
import re
import signal
import socket
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import Case, KERF, SOURCE, main  # noqa: E402
from control_channel import connect  # noqa: E402

MISBEHAVIOUR = f"{pathlib.Path(__file__).resolve().parent}/loopback_misbehaviour.py"
WAY = "G21 G90 G61\nF1200\nG1 X200\nM30\n"  # 10 s
MACHINE = """[path]
max_velocity_mm_s = 100
max_acceleration_mm_s2 = 1000
max_jerk_mm_s3 = 20000
[driver]
name = "loopback"
timeout_s = {timeout_s}
socket = "{socket}"
"""
TIMEOUT_S = 0.2  # as long as it may be: the computer of a test is busy


class Loopback(Case):
    def start_machine(self, *how):
        self.socket = self.path("m.sock")
        pathlib.Path(self.socket).unlink(missing_ok=True)
        machine = subprocess.Popen([sys.executable, "-B", MISBEHAVIOUR, SOURCE, self.socket, *how], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(machine.kill)
        deadline = time.monotonic() + 60
        while not os.path.exists(self.socket):
            self.assertIsNone(machine.poll())
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)
        self.file = self.path("machine.toml", MACHINE.format(timeout_s=TIMEOUT_S, socket=self.socket))
        return machine

    def start_kerf(self, program=WAY, *options):
        kerf = subprocess.Popen([KERF, "run", self.path("way.ngc", program), "--machine", self.file, "--trace", self.path("t.csv"), *options],
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(kerf.kill)
        return kerf

    def run_with(self, *how):
        machine = self.start_machine(*how)
        kerf = self.start_kerf()
        _, err = kerf.communicate(timeout=120)
        out, _ = machine.communicate(timeout=60)
        return kerf.returncode, err, out

    def rows(self):
        with open(self.path("t.csv")) as file:
            return [(float(row["t_s"]), float(row["x_mm"])) for row in csv.DictReader(line for line in file if not line.startswith("#"))]

    def assert_stopped_on_the_path(self):
        x = [x for _, x in self.rows()]
        self.assertLess(x[-1], 199.0)
        self.assertLess(abs(x[-1] - x[-2]), 1e-6)
        steps = [b - a for a, b in zip(x, x[1:])]
        self.assertLessEqual(max(steps), 20.0 * 0.001 * 1.0001)
        self.assertLessEqual(max(abs(b - a) for a, b in zip(steps, steps[1:])), 1000 * 1e-6 * 1.01)

    def test_a_run_over_the_socket_is_recorded_and_repeated_bit_for_bit(self):
        machine = self.start_machine("well")
        first, again = self.path("first.rec"), self.path("again.rec")
        circle = f"{SOURCE}/programs/circle.ngc"
        done = self.kerf("run", "-q", circle, "--machine", self.file, "--record", first, "--trace", self.path("t.csv"))
        self.assertEqual(done.stderr, "")
        self.assertEqual(machine.wait(timeout=60), 0)
        self.kerf("run", "-q", circle, "--machine", self.file, "--replay", first, "--record", again)
        self.assertEqual(pathlib.Path(first).read_bytes(), pathlib.Path(again).read_bytes())
        # What the machine was told are the ticks of a dry run, to the last bit.
        self.kerf("dry-run", "-q", circle, "--machine", self.file, "--trace", self.path("d.csv"))
        told = [[line.split(",")[:4] for line in pathlib.Path(self.path(name)).read_text().splitlines()] for name in ("t.csv", "d.csv")]
        self.assertEqual(told[0], told[1])

    def test_a_run_ends_with_what_a_late_machine_says_of_its_last_setpoint(self):
        for how, status in (("late", 0), ("late_trip", 4)):
            with self.subTest(how=how):
                machine = self.start_machine(how, "1", str(0.3 * TIMEOUT_S))
                program = self.path("way.ngc", WAY.replace("X200", "X40"))
                first = self.path("first.rec")
                done = self.kerf("run", "-q", program, "--machine", self.file, "--record", first, "--trace", self.path("t.csv"), status=status)
                self.assertEqual("machine fault: following error of axis x too large" in done.stderr, status == 4, done.stderr)
                out, _ = machine.communicate(timeout=60)
                # It was told to stay where it is meanwhile, which is no part of the program.
                told = int(re.search(r"told to be off at rest (\d+) ticks in a row", out)[1])
                self.assertGreater(told, len(self.rows()) + 10)
                self.assertEqual(self.rows()[-1][1], 40)
                for command in ("run", "dry-run"):
                    again = self.path("again.rec")
                    self.kerf(command, "-q", program, "--machine", self.file, "--replay", first, "--record", again, status=status)
                    self.assertEqual(pathlib.Path(first).read_bytes(), pathlib.Path(again).read_bytes())

    def test_row_70_a_machine_that_is_killed_is_a_fault(self):
        machine = self.start_machine("well")
        kerf = self.start_kerf()
        time.sleep(1.5)
        machine.kill()
        killed = time.monotonic()
        _, err = kerf.communicate(timeout=60)
        self.assertEqual(kerf.returncode, 4, err)
        self.assertIn("machine fault: the machine is gone, in line 3", err)
        self.assertLess(time.monotonic() - killed, 30)

    def test_row_70_a_machine_hears_that_kerf_is_dead(self):
        machine = self.start_machine("well")
        kerf = self.start_kerf()
        time.sleep(1.0)
        kerf.kill()
        kerf.communicate(timeout=60)
        self.assertIn("hung up on", machine.communicate(timeout=60)[0])

    def test_row_70_a_machine_that_is_stopped_is_a_fault_within_its_time_out(self):
        machine = self.start_machine("well")
        kerf = self.start_kerf()
        time.sleep(1.5)
        machine.send_signal(signal.SIGSTOP)
        _, err = kerf.communicate(timeout=60)
        machine.send_signal(signal.SIGCONT)
        self.assertEqual(kerf.returncode, 4, err)
        self.assertIn("machine fault: the machine does not answer in time, in line 3", err)
        out, _ = machine.communicate(timeout=60)
        self.assertRegex(out, "told to be off|hung up on")  # when it wakes up

    def test_row_70_a_machine_that_is_late_is_a_fault_and_the_motion_stops_on_the_path(self):
        status, err, out = self.run_with("late", "1500", str(1.5 * TIMEOUT_S))
        self.assertEqual(status, 4, err)
        self.assertIn("machine fault: the machine does not answer in time, in line 3", err)
        self.assert_stopped_on_the_path()
        self.assertIn("at rest", out)

    def test_row_72_a_machine_that_reads_in_bursts_gets_every_tick(self):
        machine = self.start_machine("stalls", "300", str(0.4 * TIMEOUT_S))
        kerf = self.start_kerf(WAY.replace("X200", "X40"))
        _, err = kerf.communicate(timeout=120)
        self.assertEqual(kerf.returncode, 0, err)
        out, _ = machine.communicate(timeout=60)
        ticks = [round(t / 0.001) for t, _ in self.rows()]
        told = int(re.search(r"at rest (\d+) ticks in a row", out)[1])
        self.assertGreaterEqual(told, len(ticks))  # after the program's last one it waits for the answer
        self.assertEqual(ticks, list(range(len(ticks))))
        self.assertGreater(len(ticks), 2000)
        self.assertEqual(self.rows()[-1][1], 40)

    def test_row_72_a_machine_that_reads_nothing_any_more_has_all_ticks_up_to_its_rest_waiting_for_it(self):
        status, err, out = self.run_with("stalls", "1500", str(15 * TIMEOUT_S))
        self.assertEqual(status, 4, err)
        self.assertIn("machine fault: the machine does not answer in time, in line 3", err)
        self.assert_stopped_on_the_path()
        self.assertRegex(out, r"told to be off at rest \d+ ticks in a row")

    def test_row_71_garbage_is_a_fault_and_the_motion_stops_on_the_path(self):
        for what in ("garbage", "torn", "version", "another_tick", "nothing_but_zeros"):
            with self.subTest(what=what):
                status, err, out = self.run_with(what, "1500")
                self.assertEqual(status, 4, err)
                self.assertIn("machine fault: the machine answers what is no answer, in line 3", err)
                self.assert_stopped_on_the_path()
                self.assertIn("at rest", out)

    def test_row_71_a_machine_that_answers_with_nothing_but_garbage_is_given_up(self):
        status, err, _ = self.run_with("garbage_for_ever", "1500")
        self.assertEqual(status, 4, err)
        self.assertIn("machine fault: the machine answers what is no answer", err)

    def test_row_69_a_drive_of_it_that_trips_is_the_runs_fault(self):
        status, err, out = self.run_with("trip", "1500")
        self.assertEqual(status, 4, err)
        self.assertIn("machine fault: following error of axis y too large, in line 3", err)
        self.assertIn("at rest", out)

    def test_an_open_door_holds_the_run_which_goes_on_once_it_is_closed_and_somebody_says_so(self):
        machine = self.start_machine("door", "1500")
        place = self.path("kerf.sock")
        kerf = self.start_kerf(WAY.replace("X200", "X60"), "--control", place)
        client = connect(self, kerf, place)
        while (status := client.status())["state"] != "held":
            time.sleep(0.02)
        self.assertTrue(status["door_open"])
        # It opens after 1.5 s of 20 mm/s. The answers of a machine elsewhere may be late.
        self.assertLess(status["position_mm"]["x"], 40)
        refused = client.ask("resume")
        self.assertEqual((refused["accepted"], refused["reason"]), (False, "the door is open"))
        while client.status()["door_open"]:
            time.sleep(0.02)
        self.assertEqual(client.status()["state"], "held")
        self.assertTrue(client.ask("resume")["accepted"])
        _, err = kerf.communicate(timeout=120)
        self.assertEqual(kerf.returncode, 0, err)
        self.assertIn("the door is open", err)
        self.assertEqual(self.rows()[-1][1], 60)
        machine.communicate(timeout=60)

    def test_the_feedrate_follows_the_inputs_of_the_machine(self):
        machine = self.start_machine("feed", "1500")
        with open(self.file, "a") as file:
            file.write("[inputs]\nadaptive_feed = 2\nfeed_stop = 5\n")
        place = self.path("kerf.sock")
        kerf = self.start_kerf("G21 G90 G61\nM52 P1\nF1200\nG1 X80\nM30\n", "--control", place, "--record", self.path("run.rec"))
        client = connect(self, kerf, place)
        while not (status := client.status())["feed_stop"]:
            time.sleep(0.02)
        self.assertEqual((status["state"], status["adaptive_feed_percent"]), ("running", 100))
        refused = client.ask("input", digital=5, value=0)
        self.assertEqual((refused["accepted"], refused["reason"]), (False, "the machine says what its inputs are"))
        client.connection.close()  # the machine lets it go on
        _, err = kerf.communicate(timeout=120)
        machine.communicate(timeout=60)
        self.assertEqual(kerf.returncode, 0, err)
        rows = self.rows()
        feeds = [(x - before) / (t - earlier) for (earlier, before), (t, x) in zip(rows, rows[1:])]
        # 1.5 s of 20 mm/s, 3 s of rest, and the other 50 mm at half of that. The answers of a machine elsewhere may be late.
        rests = [at for at, feed in enumerate(feeds) if feed == 0 and 10 < rows[at][1] < 70]
        self.assertGreater(len(rests), 2000)
        self.assertLess(len(rests), 4000)
        self.assertAlmostEqual(max(feeds[:rests[0]]), 20, delta=1e-6)
        self.assertAlmostEqual(max(feeds[rests[-1] + 1000:]), 10, delta=1e-6)
        self.assertEqual(rows[-1][1], 80)
        self.kerf("dry-run", "-q", self.path("way.ngc"), "--machine", self.file, "--replay", self.path("run.rec"), "--record", self.path("again.rec"))
        self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), pathlib.Path(self.path("run.rec")).read_bytes())

    def test_nothing_moves_while_the_machine_stops_the_feed_from_the_begin(self):
        machine = self.start_machine("feed", "0")
        with open(self.file, "a") as file:
            file.write("[inputs]\nfeed_stop = 5\n")
        kerf = self.start_kerf("G21 G90 G61\nG1 X20 F1200\nM30\n", "--record", self.path("run.rec"))
        _, err = kerf.communicate(timeout=120)
        machine.communicate(timeout=60)
        self.assertEqual(kerf.returncode, 0, err)
        first = next(t for t, x in self.rows() if x != 0)
        self.assertGreater(first, 2.5)  # of 3 s
        self.assertEqual(self.rows()[-1][1], 20)
        self.kerf("dry-run", "-q", self.path("way.ngc"), "--machine", self.file, "--replay", self.path("run.rec"), "--record", self.path("again.rec"))
        self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), pathlib.Path(self.path("run.rec")).read_bytes())

    def test_no_run_begins_while_the_door_is_open(self):
        machine = self.start_machine("door", "0")
        kerf = self.start_kerf()
        _, err = kerf.communicate(timeout=120)
        machine.communicate(timeout=60)
        self.assertEqual(kerf.returncode, 4, err)
        self.assertIn("the door is open", err)

    def test_a_machine_whose_queue_is_full_does_not_answer(self):
        self.socket = self.path("full.sock")
        self.file = self.path("machine.toml", MACHINE.format(timeout_s=TIMEOUT_S, socket=self.socket))
        with socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET) as listener:
            listener.bind(self.socket)
            listener.listen(1)  # and nobody accepts
            for _ in range(3):
                kerf = self.start_kerf()
                kerf.communicate(timeout=30)
                self.assertEqual(kerf.returncode, 5)

    def test_a_program_probes_a_workpiece_that_the_machine_file_knows_nothing_of(self):
        machine = self.start_machine("workpiece")
        kerf = self.start_kerf("G21 G90 G61\nG38.2 Z-20 F120\nG10 L20 P1 Z0\nG1 Z5 F1200\nM30\n")
        _, err = kerf.communicate(timeout=120)
        machine.communicate(timeout=60)
        self.assertEqual(kerf.returncode, 0, err)
        z = self.heights()
        # The contact is known a few ticks of 0.002 mm late, and then the tool brakes.
        self.assertGreater(min(z), -3.5)
        self.assertLess(min(z), -3.0)
        # It rests where it came to rest, which G10 L20 makes 0, and ends 5 mm above that.
        self.assertAlmostEqual(z[-1], min(z) + 5, delta=1e-6)

    def test_a_place_that_follows_from_a_probe_is_held_against_the_travel_as_it_runs(self):
        machine = self.start_machine("workpiece")
        with open(self.file, "a") as file:
            file.write("[axes.z]\nmin_mm = -200\nmax_mm = 200\n")
        # From the end of the way it leads to 195 mm, from the workpiece to 212 mm; the travel ends at 200.
        kerf = self.start_kerf("G21 G90 G61\nG38.2 Z-20 F120\nG10 L20 P1 Z0\nG1 Z215 F1200\nM30\n")
        _, err = kerf.communicate(timeout=120)
        machine.communicate(timeout=60)
        self.assertEqual(kerf.returncode, 4, err)
        self.assertIn("[E1000]", err)
        self.assertLess(max(self.heights()), 1e-6)

    def heights(self):
        with open(self.path("t.csv")) as file:
            return [float(row["z_mm"]) for row in csv.DictReader(line for line in file if not line.startswith("#"))]

    def test_what_does_not_listen_or_speaks_otherwise_is_refused_before_anything_moves(self):
        for how, why in (("version_at_once", "no answer of version 1"), ("silent", "does not answer within 1 s"), ("gone_at_once", "hangs up")):
            with self.subTest(how=how):
                status, err, _ = self.run_with(how)
                self.assertEqual(status, 5, err)
                self.assertIn(why, err)
                self.assertFalse(os.path.exists(self.path("t.csv")))
        os.unlink(self.socket)
        self.assertIn("No such file", self.kerf("run", self.path("way.ngc"), "--machine", self.file, status=5).stderr)
        self.assertIn("needs a socket", self.kerf("run", self.path("way.ngc"), "--driver", "loopback", status=5).stderr)


if __name__ == "__main__":
    main(at_once=2)
