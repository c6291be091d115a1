#!/usr/bin/env python3
"""`kerf run --control`: what an operator says of a tool."""
import pathlib
import re

from command_line import SOURCE, main
from control_channel import ControlCase


class Tools(ControlCase):
    def test_a_tool_that_is_measured_at_its_change(self):
        process, client = self.start("G21 G90 G61\nT2 M6\nG43 H2\nG1 X10 Z1 F6000\nM2\n")
        client.read_until(type="event", state="waiting", waits_for="answer")
        self.assertEqual(client.ask("tool", number=2, length_mm=1e300)["reason"], "its number or a length is impossible")
        self.assertTrue(client.ask("tool", number=2, length_mm=7.5)["accepted"])
        self.assertTrue(client.ask("resume")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.ends_at(process, 0, z=8.5)

    def test_what_was_not_measured_of_a_tool_stays_as_the_table_has_it(self):
        table = pathlib.Path(SOURCE, "programs/machines/table.toml").read_text()
        without = re.sub(r"(?s)\[tools\].*?(?=\n\[)", "", table)
        machine = self.path("m.toml", without + "\n[tools]\ntool = [{ number = 2, diameter_mm = 10, x_mm = 3, z_mm = 12.5 }]\n")
        program = "G21 G90 G61\nT2 M6\nG43 H2\nG1 X10 Y0 Z0 F6000\nG41 D2 G1 X20 Y10\nG1 X40\nM2\n"
        for measured, y in (({}, 15), ({"diameter_mm": 8}, 14)):
            with self.subTest(measured=measured):
                process, client = self.start(program, ["--machine", machine])
                client.read_until(type="event", state="waiting", waits_for="answer")
                self.assertTrue(client.ask("tool", number=2, length_mm=20, **measured)["accepted"])
                self.assertTrue(client.ask("resume")["accepted"])
                self.assertEqual(client.read_until(type="end")["exit_status"], 0)
                self.ends_at(process, 0, x=43, y=y, z=20)

    def test_a_tool_that_the_table_does_not_have(self):
        table = pathlib.Path(SOURCE, "programs/machines/table.toml").read_text()
        without = re.sub(r"(?s)\[tools\].*?(?=\n\[)", "", table)
        for text, reason in ((table, "the tool table has no such tool"), (without, None)):
            with self.subTest(reason=reason):
                process, client = self.start("G21 G90 G61\nT2 M6\nG43 H2\nG1 X10 Z1 F6000\nM2\n", ["--machine", self.path("m.toml", text)])
                client.read_until(type="event", state="waiting", waits_for="answer")
                self.assertEqual(client.ask("tool", number=999, length_mm=5).get("reason"), reason)
                self.assertTrue(client.ask("tool", number=2, length_mm=5)["accepted"])
                self.assertEqual(client.ask("tool", number=998, length_mm=5).get("reason"), reason)
                self.assertTrue(client.ask("resume")["accepted"])
                self.assertEqual(client.read_until(type="end")["exit_status"], 0)
                self.end(process, 0)

    def start_at(self, line):
        """Under G43 from line 6 on; from line 8 on with another tool."""
        return self.start("G21 G90 G61\nT2 M6\nG1 X1 F6000\nX2\nX3\nG43 H2\nG1 X10\nT3 M6\nG43 H3\nG1 Z2\nM2\n", ["--from-line", str(line)])

    def test_a_tool_whose_length_a_start_counts_on(self):
        process, client = self.start_at(7)
        why = "the start counts on lengths that are known: stop, and start again with this one in the tool table"
        for _ in ("to be confirmed", "the tool is changed in"):
            client.read_until(type="event", state="waiting", waits_for="answer")
            self.assertEqual(client.ask("tool", number=2, length_mm=7)["reason"], why)
            self.assertTrue(client.ask("resume")["accepted"])
        # At its own change after the start a tool may have another length.
        client.read_until(type="event", state="waiting", waits_for="answer")
        self.assertTrue(client.ask("tool", number=3, length_mm=7)["accepted"])
        self.assertTrue(client.ask("resume")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.ends_at(process, 0, z=9)

    def test_a_tool_whose_length_counts_behind_the_place_of_a_start(self):
        for wait in (0, 1):
            process, client = self.start_at(3)
            for at in (0, 1, 2):
                client.read_until(type="event", state="waiting", waits_for="answer")
                if at == wait:
                    self.assertTrue(client.ask("tool", number=3, length_mm=7)["accepted"])
                self.assertTrue(client.ask("resume")["accepted"])
            self.assertEqual(client.read_until(type="end")["exit_status"], 0)
            self.ends_at(process, 0, z=9)

    def test_a_tool_whose_length_leads_beyond_the_travel(self):
        process, client = self.start("G21 G90 G61\nT2 M6\nG43 H2\nG1 X10 F6000\nG1 Z1\nM2\n")
        client.read_until(type="event", state="waiting", waits_for="answer")
        self.assertTrue(client.ask("tool", number=2, length_mm=300)["accepted"])
        self.assertTrue(client.ask("resume")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 4)
        self.ends_at(process, 4, x=10, z=0)


if __name__ == "__main__":
    main(at_once=2)
