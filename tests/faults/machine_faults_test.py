#!/usr/bin/env python3
"""What breaks in the simulated table in a run, and what kerf does then; the rows are those of README.md: TEST.py KERF SOURCE_DIR [NAME...]"""
import csv
import json
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import Case, KERF, main  # noqa: E402
from control_channel import connect  # noqa: E402

# x and y at 2 to 1, on for 2.8 s; x at 89 mm/s, or 0.0894 mm a tick.
WAY = "G21 G90 G61\n{before}F6000\nG1 X250 Y125\nM30\n"
MACHINE = """[path]
max_velocity_mm_s = 100
max_acceleration_mm_s2 = 1000
max_jerk_mm_s3 = 20000
[driver]
spindle_timeout_s = 0.3
"""
AT = 1000  # the tick of the fault


def fault(kind, axis=None, at_s=AT / 1000, **more):
    keys = {"kind": f'"{kind}"', "at_s": at_s, **more}
    if axis:
        keys["axis"] = f'"{axis}"'
    return "[[driver.fault]]\n" + "".join(f"{key} = {value}\n" for key, value in keys.items())


class MachineFaults(Case):
    def run_with(self, *faults, status=4, before="", options=()):
        """The JSON of a run with these faults, and the rows of its flight recorder."""
        self.flight = pathlib.Path(self.path("flight.csv"))
        self.flight.unlink(missing_ok=True)
        done = self.kerf("run", self.path("way.ngc", WAY.format(before=before)), "--machine", self.path("m.toml", MACHINE + "".join(faults)),
                         "--json", "--flight-recorder", str(self.flight), *options, status=status)
        rows = []
        if self.flight.exists():
            with self.flight.open() as file:
                rows = [{key: float(value or "nan") for key, value in row.items()} for row in csv.DictReader(file)]
        return json.loads(done.stdout), rows

    def last_motion(self, rows, column):
        return max((i for i in range(1, len(rows)) if abs(rows[i][column] - rows[i - 1][column]) > 1e-3), default=0)

    def assert_all_axes_stop_together(self, rows, tick):
        """Within the time that 100 mm/s take at half of the drive's 20 m/s2, and both at once; then they stay."""
        x, y = self.last_motion(rows, "actual_x_mm"), self.last_motion(rows, "actual_y_mm")
        self.assertLessEqual(abs(x - y), 3)
        begin = round(rows[0]["t_s"] * 1000)
        self.assertLessEqual(begin + max(x, y), tick + 15)

    def assert_brakes_on_the_path(self, rows):
        """The setpoints end at rest, on the line, and never faster or braking harder than the limits."""
        self.assertLess(rows[-1]["x_mm"], 200)
        for row in rows:
            self.assertAlmostEqual(row["y_mm"], row["x_mm"] / 2, delta=1e-6)
        steps = [b["x_mm"] - a["x_mm"] for a, b in zip(rows, rows[1:])]
        self.assertEqual(rows[-1]["v_mm_s"], 0)
        along = [step * 5 ** 0.5 / 2 for step in steps]
        self.assertLessEqual(max(along), 0.1 * 1.0001)
        self.assertLessEqual(max(abs(b - a) for a, b in zip(along, along[1:])), 1000 * 1e-6 * 1.01)

    def check(self, report, rows, kind, axis, needs_homing, ticks):
        told = report["fault"]
        self.assertEqual((told["kind"], told["axis"], told["needs_homing"], told["line"]), (kind, axis, needs_homing, 3))
        self.assertEqual("home the machine" in report["errors"][-1]["message"], needs_homing)
        tick = round(told["t_s"] * 1000)
        self.assertGreaterEqual(tick, AT - 1)
        self.assertLessEqual(tick, AT + ticks)
        return tick

    def test_row_68_an_encoder_that_freezes_jumps_or_is_no_number_is_a_fault_within_its_ticks(self):
        # Frozen: 5 mm of following error at 0.0894 mm a tick, for which the drive (Kv 120 / s) runs at up to 690 mm/s; all axes stop as it does. The
        # other two: at once.
        for how, kind, ticks, stop_ticks in ((fault("encoder_frozen", "x"), "following_error", 60, 70), (fault("encoder_jump", "x", jump_mm=2), "encoder_jump", 2, 15),
                                             (fault("encoder_jump", "x", jump_mm=-2), "encoder_jump", 2, 15), (fault("encoder_not_a_number", "x"), "not_finite", 2, 15)):
            with self.subTest(how=how):
                report, rows = self.run_with(how)
                tick = self.check(report, rows, kind, "x", True, ticks)
                self.assertTrue(all(abs(row["actual_x_mm"]) < 300 for row in rows))  # no NaN, and no jump beyond its 2 mm
                self.assertLessEqual(round(rows[0]["t_s"] * 1000) + self.last_motion(rows, "actual_y_mm"), tick + stop_ticks)

    def test_row_68_an_encoder_whose_counter_wraps_is_a_fault_at_its_tick(self):
        # 16 bits of 1 and of 10 micrometres, and one turn of the screw.
        for range_mm in (65.536, 655.36, 10):
            for way in (1, -1):
                with self.subTest(jump_mm=way * range_mm):
                    report, rows = self.run_with(fault("encoder_jump", "x", jump_mm=way * range_mm))
                    self.assert_all_axes_stop_together(rows, self.check(report, rows, "encoder_jump", "x", True, 2))
                    # The reading wraps once; in that period the drive may follow it, with its 20 m/s2 or 0.02 mm, however far it is.
                    steps = sorted(abs(b["actual_x_mm"] - a["actual_x_mm"]) for a, b in zip(rows, rows[1:]))
                    self.assertAlmostEqual(steps[-1], range_mm, delta=0.1)
                    self.assertLess(steps[-2], 0.0894 + 0.02 + 0.001)

    def test_row_69_a_drive_that_trips_stops_all_axes_together_and_keeps_the_place(self):
        for axis in "xyz":
            with self.subTest(axis=axis):
                report, rows = self.run_with(fault("drive_trip", axis))
                self.assert_all_axes_stop_together(rows, self.check(report, rows, "drive_tripped", axis, False, 2))

    def test_row_63_following_errors_slow_and_fast_stop_all_axes_and_ask_for_homing(self):
        ticks = {}
        for kind, most in (("axis_jammed", 60), ("drive_weak", 1000)):
            report, rows = self.run_with(fault(kind, "y"))
            ticks[kind] = self.check(report, rows, "following_error", "y", True, 2 * most)
            self.assertLessEqual(round(rows[0]["t_s"] * 1000) + self.last_motion(rows, "actual_x_mm"), ticks[kind] + 15)
        self.assertGreater(ticks["drive_weak"], ticks["axis_jammed"] + 20)

    def test_row_65_a_limit_switch_in_motion_brakes_on_the_path_and_asks_for_homing(self):
        for kind in ("lower_limit_switch", "upper_limit_switch"):
            with self.subTest(kind=kind):
                report, rows = self.run_with(fault(kind, "z"))
                self.check(report, rows, "limit_switch", "z", True, 2)
                self.assert_brakes_on_the_path(rows)

    def test_row_66_a_limit_switch_that_is_stuck_at_the_start_lets_nothing_move(self):
        report, rows = self.run_with(fault("upper_limit_switch", "x", at_s=0))
        self.assertEqual(report["fault"]["kind"], "limit_switch")
        self.assertLess(max(row["x_mm"] for row in rows), 0.001)

    def test_row_67_the_loop_of_the_emergency_stop_is_lost_in_motion_or_at_the_start(self):
        report, rows = self.run_with(fault("emergency_loop"), status=8)
        self.assertIn("emergency stop: its loop is open, in line 3, at 0:00:01", report["errors"][-1]["message"])
        self.assert_brakes_on_the_path(rows)
        report, rows = self.run_with(fault("emergency_loop", at_s=0), status=8)
        self.assertLess(max(row["x_mm"] for row in rows), 0.001)

    def test_row_67_the_loop_of_the_emergency_stop_is_lost_in_a_tool_change(self):
        place = self.path("kerf.sock")
        program = self.path("tool.ngc", "G21 G90 G61\nF600\nG1 X1\nT1 M6\nG1 X200\nM30\n")
        process = subprocess.Popen([KERF, "run", program, "--control", place, "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True)
        self.addCleanup(process.kill)
        client = connect(self, process, place)
        while client.status()["waits_for"] != "answer":
            time.sleep(0.02)
        client.write('{"id":1,"command":"fault","fault":"emergency_lop"}\n{"id":2,"command":"fault","fault":"encoder_frozen"}\n')
        self.assertFalse(client.read_until(type="answer", id=1)["accepted"])
        self.assertFalse(client.read_until(type="answer", id=2)["accepted"])
        self.assertTrue(client.ask("fault", fault="emergency_loop")["accepted"])
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 8, err)
        self.assertIn("its loop is open", err + out)

    def test_an_open_door_stops_a_run_that_nobody_can_let_go_on(self):
        report, rows = self.run_with(fault("door_open"), status=7, options=("--trace", self.path("t.csv")))
        self.assertNotIn("fault", report)
        self.assertIn("the door was opened, and nobody could let the run go on", report["warnings"])
        with open(self.path("t.csv")) as file:
            rows = [{key: float(value or "nan") for key, value in row.items()} for row in csv.DictReader(line for line in file if not line.startswith("#"))]
        self.assert_brakes_on_the_path(rows)
        slowed = next(i for i in range(AT - 50, len(rows)) if rows[i]["v_mm_s"] < rows[i - 1]["v_mm_s"] - 1e-9)
        self.assertGreaterEqual(slowed, AT)
        self.assertLessEqual(slowed, AT + 100)  # in real time, on a busy computer

    def check_is_repeated_from_its_record(self, cause, status):
        self.run_with(cause, status=status, options=("--record", self.path("first.rec")))
        for command in ("run", "dry-run"):
            self.kerf(command, "-q", self.path("way.ngc"), "--machine", self.path("m.toml", MACHINE), "--replay", self.path("first.rec"),
                      "--record", self.path("again.rec"), status=status)
            self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), pathlib.Path(self.path("first.rec")).read_bytes())

    def test_a_run_that_the_door_stopped_is_repeated_from_its_record(self):
        self.check_is_repeated_from_its_record(fault("door_open"), 7)

    def test_a_run_that_ends_in_a_fault_while_the_door_holds_it_is_repeated_from_its_record(self):
        self.path("m.toml", MACHINE + fault("door_open", at_s=0.5) + fault("drive_trip", "x", at_s=1.5))
        place = self.path("kerf.sock")
        run = subprocess.Popen([KERF, "run", "-q", self.path("way.ngc", WAY.format(before="")), "--machine", self.path("m.toml"), "--control", place,
                                "--record", self.path("first.rec")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.kill)
        client = connect(self, run, place)
        client.read_until(type="event", state="held")
        client.read_until(type="event", state="fault")
        run.communicate(timeout=60)
        self.assertEqual(run.returncode, 4)
        self.kerf("dry-run", "-q", self.path("way.ngc"), "--machine", self.path("m.toml", MACHINE), "--replay", self.path("first.rec"),
                  "--record", self.path("again.rec"), status=4)
        self.assertEqual(pathlib.Path(self.path("again.rec")).read_bytes(), pathlib.Path(self.path("first.rec")).read_bytes())

    def test_a_run_whose_emergency_loop_opened_is_repeated_from_its_record(self):
        self.check_is_repeated_from_its_record(fault("emergency_loop"), 8)

    def test_a_spindle_that_does_not_start_is_a_fault_after_its_time_out(self):
        report, rows = self.run_with(fault("spindle_stuck", at_s=0), before="S1000 M3\n", status=4)
        self.assertEqual(report["fault"]["kind"], "spindle_too_slow")
        self.assertFalse(report["fault"]["needs_homing"])
        self.assertAlmostEqual(report["fault"]["t_s"], 0.3, delta=0.01)
        for row in rows:
            self.assertAlmostEqual(row["y_mm"], row["x_mm"] / 2, delta=1e-6)
        self.run_with(fault("spindle_stuck", at_s=0), status=0)  # it is not wanted

    def test_a_search_for_a_home_switch_that_fails_is_a_fault_that_asks_for_homing(self):
        # The switch would close at 900 mm. Where the travel ends nobody knows before it has.
        home = "[axes.x]\nmin_mm = -500\nmax_mm = 500\nhome_switch_mm = 900\nhome_mm = 0\nhome_search_mm_s = 100\nhome_travel_mm = {}\n"
        for travel_mm in (50, 550):
            with self.subTest(travel_mm=travel_mm):
                report, _ = self.run_with(home.format(travel_mm), options=("--home",))
                self.assertEqual((report["fault"]["kind"], report["fault"]["axis"], report["fault"]["needs_homing"]), ("homing", None, True))

    def test_the_flight_recorder_has_the_last_five_seconds_and_comes_of_faults_alone(self):
        report, rows = self.run_with(fault("drive_trip", "x", at_s=5.5), before="G4 P4\n")
        self.assertEqual(len(rows), 5000)
        self.assertGreater(rows[-1]["t_s"], 5.5)
        self.assertLess(rows[-1]["t_s"], 5.55)
        for i, row in enumerate(rows):
            self.assertAlmostEqual(row["t_s"], rows[0]["t_s"] + i / 1000, delta=1e-9)
        # Commanded and actual: the table follows within its quantisation and lag until the fault.
        before = [row for row in rows if row["t_s"] < 5.5]
        self.assertLess(max(abs(row["x_mm"] - row["actual_x_mm"]) for row in before), 1)
        self.assertGreater(max(row["x_mm"] for row in before), 100)
        self.run_with(status=0)
        self.assertFalse(self.flight.exists())

    def test_a_run_without_a_fault_has_the_ticks_that_it_has_with_one_until_then(self):
        trace, broken = self.path("t.csv"), self.path("b.csv")
        self.run_with(status=0, options=("--trace", trace))
        self.run_with(fault("drive_trip", "x"), options=("--trace", broken))
        whole, part = (pathlib.Path(name).read_text().splitlines() for name in (trace, broken))
        self.assertEqual(part[:AT], whole[:AT])

    def test_faults_that_cannot_be_are_refused_with_their_line(self):
        for text, why in ((fault("encoder_frosen", "x"), "there is no fault 'encoder_frosen', did you mean 'encoder_frozen'?"),
                          (fault("encoder_frozen"), "encoder_frozen is of an axis"), (fault("emergency_loop", "x"), "emergency_loop is of no axis"),
                          (fault("encoder_frozen", "a"), "encoder_frozen is of an axis"), (fault("drive_trip", "x", when=1), "unknown key 'when'")):
            with self.subTest(why=why):
                self.assertIn(why, self.kerf("check", self.path("w.ngc", WAY.format(before="")), "--machine", self.path("m.toml", MACHINE + text), status=3).stderr)


if __name__ == "__main__":
    main(at_once=2)
