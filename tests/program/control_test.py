#!/usr/bin/env python3
"""`kerf run --control`: another program watches a run and commands it."""
import json
import pathlib
import socket
import time

from command_line import SOURCE, main
from control_channel import ControlCase, LINE


class Control(ControlCase):
    def test_hold_status_override_and_resume(self):
        process, client = self.start()
        self.assertEqual(client.read_until(type="event")["state"], "idle")
        client.read_until(type="event", state="running")
        time.sleep(0.5)
        self.assertTrue(client.ask("hold")["accepted"])
        client.read_until(type="event", state="held")
        client.write('{"command":"status"}\n')
        held = client.read_until(type="status")
        self.assertEqual((held["state"], held["feedrate_mm_s"], held["line"], held["block"]), ("held", 0, 2, 2))
        self.assertTrue(0 < held["position_mm"]["x"] < 400)
        self.assertIn("G90", held["codes"].split())
        answer = client.ask("override", feed_percent=200, spindle_percent=110)
        self.assertTrue(answer["accepted"])
        self.assertTrue(client.ask("resume")["accepted"])
        time.sleep(0.7)
        client.write('{"command":"status"}\n')
        fast = client.read_until(type="status")
        self.assertEqual(fast["overrides"], {"feed_percent": 200, "rapid_percent": 100, "spindle_percent": 110})
        self.assertAlmostEqual(fast["feedrate_mm_s"], 200, delta=1)
        self.assertEqual(client.read_until(type="end"), {"type": "end", "exit_status": 0})
        self.assertEqual(client.reader.read(), b"")
        self.end(process, 0)
        self.assertEqual([event["number"] for event in client.events], list(range(1, len(client.events) + 1)))
        self.assertEqual([event["state"] for event in client.events], ["idle", "running", "holding", "held", "running", "idle"])

    def test_a_message_is_told_before_the_wait_that_it_comes_with(self):
        process, client = self.start("G21 G90 F6000\nM3 S1000\nG1 X20\n(MSG, turn the part)\nM0\nM2\n")
        client.read_until(type="event", state="waiting", waits_for="answer")
        self.assertEqual([event.get("text", event.get("state")) for event in client.events], ["idle", "running", "turn the part", "waiting"])
        client.write('{"command":"status"}\n')
        self.assertEqual(client.read_until(type="status")["spindle_per_min"], 1000)
        client.ask("resume")
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.end(process, 0)

    def test_what_the_state_refuses_and_what_is_no_request(self):
        process, client = self.start()
        client.read_until(type="event", state="running")
        refused = client.ask("resume")
        self.assertEqual((refused["accepted"], refused["state"], refused["reason"]), (False, "running", "it is not held"))
        for text in ("hold", "[1]", "{}", '{"command":"start"}', '{"command":7}', '{"command":"hold","now":true}', '{"command":"single_block"}',
                     '{"command":"single_block","on":1}', '{"command":"override","feed_percent":"fast"}', '{"command":"status","every_s":-1}',
                     '{"command":"events","since":-1}', "[" * 10000, "\0\xff"):
            client.write(text + "\n")
            answer = client.read_until(type="answer")
            self.assertFalse(answer["accepted"], text)
            self.assertTrue(answer["reason"], text)
        client.write('{"id":{"a":1},"command":"override","feed_percent":201}\n')
        answer = client.read_until(type="answer")
        self.assertEqual((answer["id"], answer["accepted"], answer["reason"]), ({"a": 1}, False, "an override is out of its range"))
        self.assertTrue(client.ask("stop")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 7)
        self.end(process, 7)

    def test_an_emergency_stop(self):
        process, client = self.start()
        client.read_until(type="event", state="running")
        time.sleep(0.3)
        self.assertEqual(client.ask("emergency_stop")["state"], "emergency_stop")
        self.assertEqual(client.read_until(type="end")["exit_status"], 8)
        self.end(process, 8)

    def test_messages_and_an_answer_to_a_wait(self):
        process, client = self.start("G21 G90\nG1 X10 F6000\n(MSG, tool \xe4)\nT2 M6\n(DEBUG, now #5400)\nX20\n(PRINT, over)\nM2\n")
        tool = client.read_until(type="event", event="message")
        self.assertEqual((tool["text"], tool["line"]), ("tool \xe4", 3))
        while not any(event.get("waits_for") == "answer" for event in client.events):
            client.read()
        self.assertTrue(client.ask("resume")["accepted"])
        self.assertEqual(client.read_until(type="event", event="debug")["text"], "now 2.000000")
        self.assertEqual(client.read_until(type="event", event="print")["text"], "over")
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.end(process, 0)

    def test_single_block_and_statuses_by_themselves(self):
        process, client = self.start("G21 G90 G61\nG1 X100 F6000\nX102\nM2\n")
        self.assertTrue(client.ask("single_block", on=True)["accepted"])
        client.write('{"command":"status","every_s":0.02}\n')
        seen = [client.read_until(type="status") for _ in range(20)]
        ticks = [status["tick"] for status in seen]
        self.assertEqual(ticks, sorted(ticks))
        self.assertGreater(ticks[-1] - ticks[0], 200)
        self.assertTrue(seen[-1]["single_block"])
        waits = 0
        while True:
            reply = client.read()
            if reply["type"] == "end":
                break
            if reply.get("waits_for") == "answer" and reply["type"] == "event":
                waits += 1
                client.write('{"command":"resume"}\n')
        self.assertEqual(waits, 2)
        self.end(process, 0)

    def test_a_status_and_a_list_of_events_come_back_with_their_id(self):
        process, client = self.start()
        client.write('{"command":"status","id":{"a":7}}\n{"command":"status","every_s":0.02,"id":"beat"}\n{"command":"status"}\n')
        statuses = [client.read_until(type="status") for _ in range(10)]
        self.assertEqual(statuses[0]["id"], {"a": 7})
        self.assertEqual(statuses[1]["id"], "beat")
        self.assertNotIn("id", statuses[2])  # the third was asked without one
        self.assertEqual({status["id"] for status in statuses[3:]}, {"beat"})
        client.write('{"command":"status","every_s":0}\n')
        client.events.clear()
        answer = client.ask("events", since=1)
        self.assertTrue(answer["accepted"])
        self.assertEqual([event["number"] for event in client.events][:2], [1, 2])  # all of them stand before the answer
        self.assertTrue(client.ask("stop")["accepted"])
        self.end(process, 7)

    def test_optional_stops_and_block_delete_of_text_that_is_not_read_yet(self):
        long = "G21 G90 F6000\n" + "".join(f"G1 X{100 * (i % 2)} Y{i}\n" for i in range(1, 12)) + "M0\n/ G0 X150\n/3 G0 Z7\nM1\nG0 X3\nM2\n"
        process, client = self.start(long)
        self.assertTrue(client.ask("block_delete", switches=[1])["accepted"])
        self.assertTrue(client.ask("optional_stop", on=True)["accepted"])
        client.ask("override", feed_percent=200)
        waits = []
        while True:
            reply = client.read()
            if reply["type"] == "end":
                break
            if reply["type"] == "event" and reply.get("waits_for") == "answer":
                client.write('{"command":"status"}\n')
                status = client.read_until(type="status")
                waits.append((reply["line"], status["position_mm"]["x"], status["position_mm"]["z"]))
                self.assertEqual((status["optional_stop"], status["block_delete"]), (True, [1]))
                client.write('{"command":"resume"}\n')
        self.assertEqual(waits, [(13, 100, 0), (16, 100, 7)])
        self.end(process, 0)

    def status(self, client):
        client.write('{"command":"status"}\n')
        return client.read_until(type="status")

    def status_in(self, client, state):
        """The first status in that state."""
        deadline = time.monotonic() + 60
        while (status := self.status(client))["state"] != state:
            self.assertLess(time.monotonic(), deadline, status)
            time.sleep(0.02)
        return status

    def test_a_jog_from_a_hold_and_the_way_back(self):
        process, client = self.start()
        client.read_until(type="event", state="running")
        time.sleep(0.5)
        self.assertEqual(client.ask("jog", x_mm=1)["reason"], "a program runs: hold it first")
        client.ask("hold")
        held = self.status_in(client, "held")["position_mm"]
        self.assertTrue(client.ask("jog", z_mm=25, velocity_mm_s=100)["accepted"])
        self.status_in(client, "held")
        for _ in range(20):
            self.assertTrue(client.ask("jog", x_mm_s=-40, y_mm_s=30)["accepted"])
            time.sleep(0.05)
        moving = self.status(client)
        self.assertEqual(moving["state"], "jogging")
        self.assertAlmostEqual(moving["feedrate_mm_s"], 50, delta=0.1)
        away = self.status_in(client, "held")["position_mm"]  # nobody renews it
        self.assertAlmostEqual((away["x"] - held["x"]) * 3, away["y"] * -4, delta=1e-6)
        self.assertEqual(away["z"], 25)
        client.ask("resume")
        client.read_until(type="event", state="returning")
        client.read_until(type="event", state="running")
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.ends_at(process, 0, x=400)

    def test_a_stop_of_a_line_before_the_program_ends_that_alone(self):
        process, client = self.start("G21 G90\nG1 X1 F6000\nM2\n", ["--wait-start"])
        client.read_until(type="event", state="idle")
        self.assertTrue(client.ask("mdi", line="G21 G1 X50 F600")["accepted"])
        client.read_until(type="event", state="running")
        self.assertTrue(client.ask("stop")["accepted"])
        self.assertLess(self.status_in(client, "idle")["position_mm"]["x"], 50)
        self.assertTrue(client.ask("start")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.ends_at(process, 0, x=1)

    def test_lines_and_jogs_before_the_program(self):
        process, client = self.start("G90\nG1 X1 F6000\nM2\n", ["--wait-start"])
        client.read_until(type="event", state="idle")
        self.assertTrue(client.ask("mdi", line="G21 G91 G1 X5 F6000")["accepted"])
        self.status_in(client, "idle")
        wrong = client.ask("mdi", line="G1 X1 F-1")
        self.assertEqual((wrong["accepted"], wrong["state"]), (False, "idle"))
        self.assertRegex(wrong["reason"], r"F must not be negative \[E0120\]")
        self.assertTrue(client.ask("jog", y_mm=2)["accepted"])
        self.status_in(client, "idle")
        self.assertTrue(client.ask("mdi", line="G10 L2 P1 X30")["accepted"])
        self.assertEqual(self.status_in(client, "idle")["position_mm"], {"x": 5, "y": 2, "z": 0})
        self.assertEqual(client.ask("home")["reason"], "no axis has a home switch")
        self.assertTrue(client.ask("start")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.ends_at(process, 0, x=31)

    def test_an_operators_line_that_fails_as_it_runs(self):
        process, client = self.start("G90\nG1 X1 F6000\nM2\n", ["--wait-start"])
        client.read_until(type="event", state="idle")
        self.assertTrue(client.ask("mdi", line="G38.2 X1 F1000")["accepted"])
        self.assertRegex(client.read_until(type="event", event="message")["text"], r"\[E0854\]")
        self.status_in(client, "idle")
        self.assertTrue(client.ask("stop")["accepted"])
        client.read_until(type="end")
        process.wait(timeout=60)

    def test_a_line_that_is_too_long_is_refused_and_the_next_one_heard(self):
        process, client = self.start(LINE)
        client.read_until(type="event", state="running")
        client.write("x" * 200_000 + "\n")
        self.assertEqual(client.read_until(type="answer")["accepted"], False)
        self.assertTrue(client.ask("emergency_stop")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 8)
        process.wait(timeout=60)

    def test_a_run_that_waits_for_its_start_may_be_stopped(self):
        process, client = self.start(options=["--wait-start"])
        client.read_until(type="event", state="idle")
        self.assertTrue(client.ask("stop")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 7)
        process.wait(timeout=60)

    def test_a_run_that_nobody_can_let_go_on_is_stopped(self):
        for program, options, commands in ((LINE, [], [("hold", {}, "held")]), (LINE, [], [("override", {"feed_percent": 0}, None)]),
                                           (LINE, ["--wait-start"], []), ("G21 G90\nG1 X1 F6000\nM0\nM2\n", [], [])):
            with self.subTest(options=options, commands=commands):
                process, client = self.start(program, options)
                for command, more, state in commands:
                    self.assertTrue(client.ask(command, **more)["accepted"])
                    if state:
                        client.read_until(type="event", state=state)
                client.connection.shutdown(socket.SHUT_WR)
                self.assertEqual(process.wait(timeout=60), 7)

    def test_a_run_that_an_input_of_the_feed_holds_is_stopped_once_nobody_can_set_it(self):
        table = (pathlib.Path(SOURCE) / "programs/machines/table.toml").read_text()
        machine = self.path("inputs.toml", table + "\n[inputs]\nadaptive_feed = 2\nfeed_stop = 5\n")
        for setting in ({"digital": 5, "value": 1}, {"analog": 2, "value": 0}):
            with self.subTest(setting=setting):
                process, client = self.start("G21 G90\nM52 P1\nG1 X400 F6000\nM2\n", ["--machine", machine])
                client.read_until(type="event", state="running")
                self.assertTrue(client.ask("input", **setting)["accepted"])
                client.connection.shutdown(socket.SHUT_WR)
                self.assertEqual(process.wait(timeout=60), 7)

    def test_a_client_that_has_said_all_hears_its_answers(self):
        process, client = self.start(LINE, [])
        client.write('{"command":"hold","id":1}\n{"command":"resume","id":2}\n{"command":"events","since":1,"id":3}\n')
        client.connection.shutdown(socket.SHUT_WR)
        heard = [json.loads(line) for line in client.reader]
        self.assertEqual(sorted(one["id"] for one in heard if one["type"] == "answer"), [1, 2, 3])
        process.wait(timeout=60)

    def test_a_home_switch_that_is_not_there(self):
        table = (pathlib.Path(SOURCE) / "programs/machines/table.toml").read_text()
        home = "home_switch_mm = -499\nhome_search_mm_s = -100\nhome_travel_mm = 80\n"
        machine = self.path("home.toml", table.replace("[axes.x]\n", "[axes.x]\n" + home))
        process, client = self.start(options=["--machine", machine, "--home"])
        client.read_until(type="event", state="homing")
        self.assertEqual(client.read_until(type="event", event="message")["text"], "homing x: its switch did not close within 80 mm")
        client.read_until(type="event", state="fault")
        self.assertEqual(client.read_until(type="end")["exit_status"], 4)
        process.wait(timeout=60)
        refused = self.kerf("run", self.path("part.ngc", LINE), "--machine", machine, status=4)
        self.assertIn("the axes are not homed: home first", refused.stderr)
        self.kerf("dry-run", self.path("part.ngc", LINE), "--machine", machine)

    def test_inputs_of_the_machine_that_the_feedrate_follows(self):
        table = (pathlib.Path(SOURCE) / "programs/machines/table.toml").read_text()
        machine = self.path("inputs.toml", table + "\n[inputs]\nadaptive_feed = 2\nfeed_stop = 5\n")
        process, client = self.start("G21 G90\nM52 P1\nG1 X400 F6000\nM2\n", ["--machine", machine])
        client.read_until(type="event", state="running")
        self.assertTrue(client.ask("input", analog=2, value=0.5)["accepted"])
        for _ in range(50):  # a slow computer plans it later
            time.sleep(0.1)
            client.write('{"command":"status"}\n')
            slow = client.read_until(type="status")
            if abs(slow["feedrate_mm_s"] - 50) <= 1:
                break
        self.assertAlmostEqual(slow["feedrate_mm_s"], 50, delta=1)
        self.assertEqual((slow["adaptive_feed_percent"], slow["feed_stop"]), (50, False))
        self.assertTrue(client.ask("input", digital=5, value=1)["accepted"])
        time.sleep(0.5)
        client.write('{"command":"status"}\n')
        stopped = client.read_until(type="status")
        self.assertEqual((stopped["feedrate_mm_s"], stopped["state"], stopped["feed_stop"]), (0, "running", True))
        for wrong in ({"analog": 1, "value": 0.5}, {"digital": 2, "value": 1}, {"analog": 2, "value": 1.5}):
            self.assertFalse(client.ask("input", **wrong)["accepted"], wrong)
        for text in ('{"command":"input"}', '{"command":"input","analog":2}', '{"command":"input","analog":2,"digital":5,"value":1}',
                     '{"command":"input","digital":5,"value":0.5}', '{"command":"input","digital":5,"value":2}'):
            client.write(text + "\n")
            self.assertFalse(client.read_until(type="answer")["accepted"], text)
        client.ask("input", analog=2, value=1)
        self.assertTrue(client.ask("input", digital=5, value=0)["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.end(process, 0)


if __name__ == "__main__":
    main(at_once=2)
