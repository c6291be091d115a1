#!/usr/bin/env python3
"""The ways into `kerf run --control`: pipes, standard input and output, a socket; and what ends them."""
import contextlib
import os
import pathlib
import socket
import stat
import subprocess
import time

from command_line import KERF, SOURCE, main
from control_channel import Client, ControlCase, LINE


class Channel(ControlCase):
    def test_two_pipes(self):
        from_kerf, to_us = os.pipe()
        from_us, to_kerf = os.pipe()
        process = self.run_kerf(f"{from_us},{to_us}", fds=(from_us, to_us))
        os.close(from_us)
        os.close(to_us)
        client = Client(self, os.fdopen(from_kerf, "rb"), os.fdopen(to_kerf, "wb"))
        self.addCleanup(client.reader.close)
        client.read_until(type="event", state="running")
        self.assertTrue(client.ask("hold")["accepted"])
        client.read_until(type="event", state="held")
        self.assertTrue(client.ask("resume")["accepted"])
        client.writer.close()  # no more commands; events go on
        self.assertEqual(client.read_until(type="end")["exit_status"], 0)
        self.end(process, 0)

    def test_standard_input_and_output(self):
        part = self.path("part.ngc", LINE)
        for words in ([], ["-q", "--json"], ["-q", "--trace", "-"]):
            self.kerf("run", part, "--control", "0,1", *words, status=2)
        self.kerf("run", "-", "--control", "0,1", "-q", status=2)
        process = subprocess.Popen([KERF, "run", part, "--control", "0,1", "-q", "--trace", self.path("run.csv")],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.addCleanup(process.kill)
        client = Client(self, process.stdout, process.stdin)
        client.read_until(type="event", state="running")
        self.assertTrue(client.ask("stop")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 7)
        self.assertEqual(client.reader.read(), b"")
        self.end(process, 7)
        process.stdin.close()
        process.stdout.close()

    def test_a_program_is_stopped_at_a_wait_once_nobody_can_answer(self):
        process, client = self.start("G21 G90\nG1 X10 F6000\nM0\nX20\nM2\n")
        client.read_until(type="event", state="running")
        client.connection.close()
        client.reader.close()
        client.writer.close()
        self.end(process, 7)

    def test_a_socket_is_for_its_owner_and_goes_with_the_run(self):
        where = self.path("kerf.sock")
        slow = "G21 G90\nG1 X400 F400\nM2\n"  # 60 s: a busy computer takes seconds for what comes before the stop
        stale = socket.socket(socket.AF_UNIX)
        stale.bind(where)
        stale.close()  # nobody listens any more
        process = self.run_kerf(where, slow)
        deadline = time.monotonic() + 60
        connection = socket.socket(socket.AF_UNIX)
        self.addCleanup(connection.close)
        while time.monotonic() < deadline:
            try:
                connection.connect(where)
                break
            except (ConnectionRefusedError, FileNotFoundError):
                time.sleep(0.02)
        connection.settimeout(60)
        client = self.client(connection)
        client.write('{"command":"events","since":1}\n')
        client.read_until(type="event", state="running")  # it has read its program, which the second one writes anew
        self.assertEqual(stat.S_IMODE(os.stat(where).st_mode), 0o600)
        second = self.run_kerf(where, slow)
        self.assertEqual(second.wait(timeout=60), 5)
        self.assertIn(b"Address already in use", second.stderr.read())
        other = socket.socket(socket.AF_UNIX)
        self.addCleanup(other.close)
        other.connect(where)
        other.settimeout(60)
        watcher = self.client(other)
        watcher.write('{"command":"events","since":1}\n')
        self.assertEqual(watcher.read_until(type="event")["number"], 1)
        self.assertTrue(client.ask("stop")["accepted"])
        self.assertEqual(client.read_until(type="end")["exit_status"], 7)
        self.assertEqual(watcher.read_until(type="end")["exit_status"], 7)
        self.assertEqual(process.wait(timeout=60), 7)
        self.assertFalse(os.path.exists(where))

    def test_the_socket_of_a_run_that_may_not_begin_goes_with_it(self):
        table = pathlib.Path(SOURCE, "programs/machines/table.toml").read_text()
        switch = "[axes.x]\nhome_switch_mm = -499\nhome_search_mm_s = -100\n"
        where = self.path("kerf.sock")
        self.kerf("run", self.path("part.ngc", LINE), "--machine", self.path("m.toml", table.replace("[axes.x]\n", switch)), "--control", where, status=4)
        self.assertFalse(os.path.exists(where))

    def test_a_client_that_does_not_read_keeps_nobody_waiting(self):
        process, client = self.start()
        with contextlib.suppress(BrokenPipeError, ConnectionResetError):  # it is dropped
            client.write('{"command":"status"}\n' * 20000)
        self.assertEqual(process.wait(timeout=60), 0)

    def test_a_client_that_reads_gets_megabytes_at_once(self):
        prints = "".join("(PRINT," + "\u00e9" * 230 + ")\n" for _ in range(1000))
        process, client = self.start("G21\nG1 X1 F6000\n" + prints + "M0\nM2\n")
        client.read_until(type="event", waits_for="answer")
        self.assertEqual(sum(event["event"] == "print" for event in client.events), 1000)
        client.events.clear()
        client.ask("events", since=1)
        self.assertEqual(sum(event["event"] == "print" for event in client.events), 1000)
        client.ask("resume")
        process.communicate(timeout=60)  # the messages are on standard error, too
        self.assertEqual(process.returncode, 0)

    def test_a_channel_that_is_none_is_refused_before_anything_moves(self):
        regular = os.open(self.path("regular", "x"), os.O_RDONLY)
        self.addCleanup(os.close, regular)
        for control, said in (("77", b"descriptor 77: Bad file descriptor"), (str(regular), b"Invalid argument"), ("/nowhere/kerf.sock", b"No such file"),
                              (self.path("x" * 200), b"is no path of 1 to"), (self.path("part.ngc", LINE), b"Address already in use")):
            process = self.run_kerf(control, fds=(regular,))
            self.assertEqual(process.wait(timeout=60), 5, control)
            self.assertIn(said, process.stderr.read())


if __name__ == "__main__":
    main(at_once=2)
