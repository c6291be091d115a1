#!/usr/bin/env python3
"""`kerf run --control`: what a client hears of a run that ends with a fault or an error."""
import pathlib
import socket
import subprocess
import time

from command_line import SOURCE, main
from control_channel import ControlCase

JUMP = {"fault": "encoder_jump", "axis": "x", "jump_mm": 10}


class Ends(ControlCase):
    def start_live(self, text):
        """`kerf run -` of text that comes as it runs."""
        ours, theirs = socket.socketpair()
        self.addCleanup(ours.close)
        ours.settimeout(60)
        process = self.run_kerf(str(theirs.fileno()), fds=(theirs.fileno(),), stdin=subprocess.PIPE, path="-")
        theirs.close()
        process.stdin.write(text)
        process.stdin.close()
        process.stdin = None
        return process, self.client(ours)

    def last_words(self, process, client, status):
        """Lines and texts of what Kerf said; standard error has each of them."""
        self.assertEqual(client.read_until(type="end")["exit_status"], status)
        self.assertEqual(process.wait(timeout=60), status)
        numbers = [event["number"] for event in client.events]
        self.assertEqual(numbers, list(range(1, len(numbers) + 1)))
        said = [(event["line"], event["text"]) for event in client.events if event["event"] == "message"]
        errors = process.stderr.read().decode()
        for _, text in said:
            self.assertIn(text, errors)
        return said

    def test_a_fault_of_the_machine_is_told(self):
        process, client = self.start()
        client.read_until(type="event", state="running")
        client.ask("fault", **JUMP)
        (line, text), = self.last_words(process, client, 4)
        self.assertEqual(line, 2)
        self.assertRegex(text, r"^machine fault: encoder of axis x jumped, in line 2, at .*; home the machine: its place may be lost$")

    def test_each_error_in_text_that_comes_as_it_runs_is_told_with_its_line(self):
        process, client = self.start_live(b"G21 G90\nG1 X10 F6000\nX20 F-1\nG77\n")
        self.assertEqual(self.last_words(process, client, 1), [(3, "F must not be negative [E0120]"),
                                                               (4, "G77 is not known [E0100]")])

    def test_a_block_that_leaves_the_travel_is_told(self):
        process, client = self.start_live(b"G21 G90\nG1 X10 F6000\nX2000\n")
        self.assertEqual(self.last_words(process, client, 4), [(3, "x goes 1500 mm beyond its upper limit of 500 mm [E1000]")])

    def test_a_run_without_errors_says_no_last_words(self):
        process, client = self.start_live(b"G21 G90\nG1 X10 F6000\nM2\n")
        self.assertEqual(self.last_words(process, client, 0), [])
        process, client = self.start()
        client.ask("stop")
        self.assertEqual(self.last_words(process, client, 7), [])

    def test_what_homing_said_is_not_said_again(self):
        table = pathlib.Path(SOURCE, "programs/machines/table.toml").read_text()
        home = "home_switch_mm = -499\nhome_search_mm_s = -100\nhome_travel_mm = 80\n"
        machine = self.path("home.toml", table.replace("[axes.x]\n", "[axes.x]\n" + home))
        process, client = self.start(options=["--machine", machine, "--home"])
        self.assertEqual(self.last_words(process, client, 4), [(None, "homing x: its switch did not close within 80 mm")])

    def test_an_emergency_stop_behind_a_fault_stays(self):
        process, client = self.start()
        client.read_until(type="event", state="running")
        time.sleep(1.0)  # it brakes for a while
        client.ask("fault", **JUMP)
        client.read_until(type="event", state="fault")
        client.write('{"command":"emergency_stop"}\n')
        self.last_words(process, client, 4)
        states = [event["state"] for event in client.events if event["event"] == "state"]
        self.assertEqual(states, ["idle", "running", "fault", "emergency_stop"])


if __name__ == "__main__":
    main(at_once=2)
