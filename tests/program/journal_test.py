#!/usr/bin/env python3
"""`--journal` and `--continue`: a run that was killed goes on where it was; KERF_KILLS says how many are killed (10)."""
import json
import os
import pathlib
import random
import re
import signal
import socket
import subprocess
import time

from command_line import Case, KERF, main

# Ways of 4 mm in 0.1 s or so, one a line.
LINES = "G21 G90 G61 F3000\n" + "".join(f"G1 X{4 * (k % 2)} Y{2 * k}\n" for k in range(100)) + "M2\n"
ROUNDED = LINES.replace("G61", "G64 P0.02 Q0")
SHORT = "G21 G90 G61 F3000\nG1 X5\nY5\nM2\n"
KILLS = int(os.environ.get("KERF_KILLS", "10"))


class Journal(Case):
    def until_killed(self, run):
        """What a run gives that is killed; again where the computer was busy elsewhere: no tick for 0.25 s."""
        for _ in range(10):
            given, status = run()
            if status != 4:
                break
        self.assertEqual(status, -signal.SIGKILL)
        return given

    def killed(self, program, after_s):
        """Runs until then and is killed: the time of the run that was seen last."""
        return self.until_killed(lambda: self.run_until(program, after_s))

    def run_until(self, program, after_s):
        ours, theirs = socket.socketpair()
        with ours:
            process = subprocess.Popen([KERF, "run", program, "--journal", program + ".journal", "--control", str(theirs.fileno()), "-q"],
                                       stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL, pass_fds=[theirs.fileno()])
            theirs.close()
            ours.sendall(b'{"command":"status","every_s":0.01}\n')
            lines, run_s, end = ours.makefile("rb"), 0.0, None
            for line in lines:
                told = json.loads(line)
                if told["type"] == "status":
                    run_s = told["run_s"]
                if end is None and run_s > 0.0:
                    end = time.monotonic() + after_s
                if end is not None and time.monotonic() >= end:
                    break
            process.kill()
            for line in lines:  # what had been said by then
                if line.endswith(b"\n") and json.loads(line)["type"] == "status":
                    run_s = json.loads(line)["run_s"]
            return run_s, process.wait()

    def proposed(self, program, *words):
        """The line that is shown; nobody confirms it, so nothing moves."""
        stderr = self.kerf("run", program, "--continue", *words, status=2).stderr
        self.assertIn("nobody is there to confirm", stderr)
        return int(re.search(r":(\d+): ", stderr).group(1))

    def killed_under_commands(self, text, commands):
        """The program of a run that waits for its start, is told all this, and is killed some seconds after it."""
        program = self.path("told.ngc", text)
        return self.until_killed(lambda: (program, self.run_under_commands(program, commands)))

    def run_under_commands(self, program, commands):
        ours, theirs = socket.socketpair()
        with ours:
            process = subprocess.Popen([KERF, "run", program, "--journal", program + ".journal", "--control", str(theirs.fileno()), "-q", "--wait-start"],
                                       stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL, pass_fds=[theirs.fileno()])
            self.addCleanup(process.kill)
            theirs.close()
            lines = ours.makefile("r")

            def read_until(**wanted):
                for line in lines:
                    told = json.loads(line)
                    if all(told.get(key) == value for key, value in wanted.items()):
                        return
                self.fail(f"no {wanted}")

            read_until(type="event", state="idle")
            for command, after in commands:
                if command == {"command": "hold"}:
                    time.sleep(2.5)  # the run has come to a place that the journal has
                ours.sendall(json.dumps(command).encode() + b"\n")
                read_until(type="answer", accepted=True)
                if after:
                    read_until(type="event", **after)
            time.sleep(2.5)
            process.kill()
            return process.wait()

    def test_does_not_go_on_where_an_operator_changed_what_the_program_does(self):
        # Each leads elsewhere than the program by itself, the last two farther on than the run came. Without them it goes on.
        def line(text):
            return {"command": "mdi", "line": text}, {"state": "idle"}

        start = ({"command": "start"}, None)
        tool = ({"command": "tool", "number": 2, "length_mm": 30}, None)
        way = "G1 X1 Z1\n" + "".join(f"X{k}\n" for k in range(2, 60))
        moved, changed = "G21 G90 G61 F600\nG54\n" + way + "M2\n", "G21 G90 G61 F600\nG43 H2\n" + way + "M2\n"
        farther, passes = "G21 G90 G61 F600\n" + way + "G55\nX1\nM2\n", "G21 G90 G61 G1 F600\n" + "/M8\nX5\nX0\n" * 20 + "M2\n"
        # Held, the tool is on the path as long as nobody jogs.
        hold = ({"command": "hold"}, {"state": "held"})
        switched = ({"command": "block_delete", "switches": [1]}, None)
        for text, commands, what, off_mm in (
            (moved, [line("G10 L2 P1 X50"), start], "line was run", 50),
            (changed, [tool, start], "tool's length", 30),
            (moved, [line("G10 L2 P1 X50"), start, hold], "line was run", 50),
            (farther, [line("G10 L2 P2 Z30"), start], "line was run", 0),
            (passes, [switched, start], "block delete", 0),
        ):
            with self.subTest(what=what, off_mm=off_mm):
                program = self.killed_under_commands(text, commands)
                self.assertIn(what, self.kerf("run", program, "--continue", status=1).stderr)
                # By the places alone, as where the machine's answers led elsewhere.
                journal = pathlib.Path(program + ".journal")
                journal.write_text("".join(record for record in journal.read_text().splitlines(True) if '"change"' not in record))
                if off_mm > 0:
                    stderr = self.kerf("run", program, "--continue", status=1).stderr
                    found = re.search(r"([\d.]+) mm from where the program leads by itself", stderr)
                    self.assertTrue(found, stderr)
                    self.assertGreater(float(found[1]), 1)
                    self.assertLessEqual(float(found[1]), off_mm + 1e-3)
        self.assertGreater(self.proposed(self.killed_under_commands(moved, [start])), 5)
        self.assertGreater(self.proposed(self.killed_under_commands(changed, [start])), 5)

    def begin_s(self, program, line):
        return json.loads(self.kerf("explain", program, "--line", str(line), "--json").stdout)["block"]["begin_s"]

    def test_a_killed_run_goes_on_at_a_line_before_the_kill_and_no_more_than_two_seconds_back(self):
        seed = int(os.environ.get("KERF_SEED", str(random.randrange(10**6))))
        dice = random.Random(seed)
        programs = [self.path("lines.ngc", LINES), self.path("rounded.ngc", ROUNDED)]
        worst_s = 0.0
        for kill in range(KILLS):
            program = programs[kill % 2]
            with self.subTest(seed=seed, kill=kill):
                run_s = self.killed(program, dice.uniform(0.02, 4.0))
                line = self.proposed(program)
                back_s = run_s - self.begin_s(program, line)
                worst_s = max(worst_s, back_s)
                self.assertGreaterEqual(back_s, 0.0)
                self.assertLessEqual(back_s, 2.0)
        if KILLS > 10:
            print(f"{KILLS} kills, seed {seed}: at most {worst_s:.3f} s back")

    def test_goes_on_and_keeps_its_journal(self):
        program = self.path("lines.ngc", LINES)
        self.killed(program, 1.5)
        line = self.proposed(program)
        self.assertGreater(line, 3)
        journal = pathlib.Path(program + ".journal")
        before = journal.read_text()
        done = self.kerf("run", program, "--continue", "--yes")
        self.assertIn(f"  started at      line {line}\n", done.stdout)
        self.assertTrue(journal.read_text().startswith(before))
        said = self.kerf("run", program, "--continue", "--yes", status=1).stderr
        self.assertIn("has come to its end", said)

    def test_a_torn_end_is_dropped(self):
        program = self.path("lines.ngc", LINES)
        self.killed(program, 1.5)
        line = self.proposed(program)
        journal = pathlib.Path(program + ".journal")
        whole = journal.read_bytes()
        journal.write_bytes(whole + b"0123456789abcdef {\"record\":\"pla")
        self.assertEqual(self.proposed(program), line)

    def test_a_program_or_machine_that_was_changed_is_refused(self):
        table = (pathlib.Path(self.folder) / "table.toml")
        table.write_text("[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 50000\n[probe]\nheight_map = 'map.txt'\n")
        surface = self.path("map.txt", "0 0 -1\n100 0 -1\n0 100 -1\n100 100 -1\n")
        called = self.path("way.ngc", "o<way> sub\nG1 X1\no<way> endsub\nM2\n")
        program = self.path("part.ngc", "G21 G90 G61 F3000\no<way> call\nG1 X60\nG1 X0\nG1 X60\nM2\n")
        journal = program + ".journal"
        process = subprocess.Popen([KERF, "run", program, "--machine", str(table), "--journal", journal, "-q"], stdin=subprocess.DEVNULL)
        time.sleep(1.5)
        process.kill()
        process.wait()
        words = ["run", program, "--machine", str(table), "--continue"]
        self.kerf(*words, status=2)
        for other in (["--block-delete"], ["--start", "0,0,10"]):
            self.assertIn("is not the program", self.kerf(*words, *other, status=1).stderr)
        done = self.kerf(*words, "--g54", "50,0,0", "--json", status=3)
        self.assertIn("the machine is not that", done.stderr)
        self.assertEqual(json.loads(done.stdout)["exit_status"], 3)
        for name, status, said in ((program, 1, "is not the program"), (called, 1, "is not the program"), (table, 3, "the machine is not that"),
                                   (surface, 3, "the machine is not that")):
            path = pathlib.Path(name)
            text = path.read_text()
            path.write_text(text.replace("G1 X", "G1  X") if said.endswith("program") else text + "\n")
            self.assertIn(said, self.kerf(*words, status=status).stderr)
            path.write_text(text)
        self.kerf(*words, status=2)

    def test_one_that_was_stopped_goes_on_and_one_that_is_new_says_that_the_last_was_not_ended(self):
        program = self.path("lines.ngc", LINES)
        journal = program + ".journal"
        process = subprocess.Popen([KERF, "run", program, "--journal", journal, "-q"], stdin=subprocess.DEVNULL)
        time.sleep(1.2)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=60), 130)
        self.assertGreater(self.proposed(program), 2)
        self.killed(program, 0.3)
        short = self.kerf("run", self.path("short.ngc", SHORT), "--journal", journal)
        self.assertIn("was not brought to an end", short.stdout)

    def test_without_a_journal_nothing_goes_on(self):
        program = self.path("short.ngc", SHORT)
        self.assertIn("short.ngc.journal", self.kerf("run", program, "--continue", "--yes", status=5).stderr)
        pathlib.Path(program + ".journal").write_text("nothing\n")
        self.assertIn("no run is in it", self.kerf("run", program, "--continue", "--yes", status=5).stderr)
        self.kerf("run", program, "--journal", str(self.folder / "no" / "folder"), status=5)
        self.kerf("run", program, "--continue", "--from-line", "2", status=2)

    def test_has_the_end_of_a_run_that_could_not_begin(self):
        program = self.path("short.ngc", SHORT)
        self.kerf("run", program, "--journal", program + ".journal", "--trace", str(self.folder / "no" / "folder"), status=5)
        self.assertNotIn("was not brought to an end", self.kerf("run", program, "--journal", program + ".journal").stdout)

    def test_is_written_over_no_other_file(self):
        program, other = self.path("short.ngc", SHORT), self.path("other.txt", "something else\n")
        self.kerf("run", program, "--journal", other, status=5)
        self.assertEqual(pathlib.Path(other).read_text(), "something else\n")
        self.kerf("run", program, "--journal", self.path("empty.journal", ""), "-q")
        os.mkfifo(self.path("fifo"))
        self.kerf("run", program, "--journal", self.path("fifo"), status=5)

    def test_the_motion_is_the_same_with_a_journal(self):
        program = self.path("short.ngc", SHORT)
        for name, words in (("with", ["--journal", program + ".journal"]), ("without", [])):
            self.kerf("run", program, *words, "--trace", self.path(name + ".csv"), "-q")
        commanded = [[line.split(",")[:9] for line in pathlib.Path(self.path(name + ".csv")).read_text().splitlines()] for name in ("with", "without")]
        self.assertEqual(*commanded)


if __name__ == "__main__":
    main(at_once=2)
