#!/usr/bin/env python3
"""Faults of files, streams, signals and the system around `kerf`; the rows are those of README.md: TEST.py KERF SOURCE_DIR [NAME...]"""
import gzip
import json
import os
import re
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "program"))
from command_line import Case, KERF, LONG, SOURCE, SQUARE, main  # noqa: E402
from control_channel import connection_to  # noqa: E402

ESCAPES = "\x1b[31m\x07\x9b2J"


class ProcessFaults(Case):
    def start(self, *words, **how):
        process = subprocess.Popen([KERF, *words], stdout=how.pop("stdout", subprocess.PIPE), stderr=subprocess.PIPE, text=True, **how)
        self.addCleanup(process.kill)
        return process

    def wait_for_bytes(self, path, count, process):
        deadline = time.monotonic() + 60
        while not (os.path.exists(path) and os.path.getsize(path) >= count):
            self.assertIsNone(process.poll())
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def limited(self, words, **limits):
        """kerf under limits of the system, given as RLIMIT names."""
        def limit():
            for name, value in limits.items():
                resource.setrlimit(getattr(resource, name), (value, value))
        return subprocess.run([KERF, *words], capture_output=True, text=True, timeout=120, preexec_fn=limit)

    # Programs that are files

    def test_row_25_a_call_never_leaves_the_folder_of_the_program(self):
        (self.folder / "inner").mkdir()
        evil = self.path("evil.ngc", "o<evil> sub\nG0 X7\no<evil> endsub\nM2\n")
        for name in ("missing", "../evil", evil.removesuffix(".ngc")):
            with self.subTest(name=name):
                program = self.path("inner/main.ngc", f"G21\no<{name}> call\nM2\n")
                done = self.kerf("check", program, status=1)
                self.assertRegex(done.stderr, r"main\.ngc:2:\d+: error: ")
                self.assertEqual(done.stdout, "")

    def test_row_27_a_program_that_changes_while_it_runs_comes_to_rest(self):
        # Far more text than is read ahead.
        program = self.path("long.ngc", "G21 G90\nF6000\n" + "".join(f"G1 X{i % 2 / 100} ({'-' * 100})\n" for i in range(20_000)) + "M30\n")
        trace = self.path("t.csv")
        process = self.start("run", program, "--trace", trace, "--window", "10")
        self.wait_for_bytes(trace + ".incomplete", 1, process)
        with open(program, "a") as file:
            file.write("G0 X200\n")
        err = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 5, err)
        self.assertIn("long.ngc: changed while it was read", err)
        with open(trace) as file:  # whole: all that ran is in it
            last = file.read().splitlines()[-1].split(",")
        self.assertEqual(float(last[3]), 0.0)

    def test_row_61_a_program_that_is_edited_while_it_is_held_is_not_resumed_into_the_other_text(self):
        def text(end):
            return "G21 G90\nF6000\n" + "".join(f"G1 X{i % 2 / 100} ({'-' * 100})\n" for i in range(20_000)) + end
        place, program, trace = self.path("c.sock"), self.path("held.ngc", text("M30\n")), self.path("t.csv")
        process = self.start("run", program, "--trace", trace, "--window", "10", "--control", place, stdin=subprocess.DEVNULL)
        with connection_to(self, process, place) as client:
            lines = client.makefile("rw")

            def ask(command):
                lines.write(json.dumps({"command": command}) + "\n")
                lines.flush()
                while (told := json.loads(lines.readline()))["type"] not in ("answer", "status"):
                    pass
                return told
            self.assertTrue(ask("hold")["accepted"])
            while ask("status")["state"] != "held":
                time.sleep(0.02)
            pathlib.Path(program).write_text(text("G1 X200 F1\nM30\n"))
            ask("resume")
            err = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 5, err)
        self.assertIn("held.ngc: changed while it was read", err)
        with open(trace) as file:
            rows = [line.split(",") for line in file.read().splitlines()[1:]]
        self.assertLess(max(float(row[6]) for row in rows), 0.02)
        self.assertEqual(float(rows[-1][3]), 0.0)

    def test_row_28_an_m_code_runs_no_program(self):
        script = self.path("M100", f"#!/bin/sh\ntouch {self.path('ran')}\n")
        os.chmod(script, 0o755)
        self.assertIn("M100", self.kerf("run", self.path("m.ngc", "M100\nM2\n"), status=1).stderr)
        self.assertFalse(os.path.exists(self.path("ran")))

    def test_row_29_control_characters_never_reach_a_terminal(self):
        folder = os.fsencode(self.folder)
        names = [os.fsencode(f"a{ESCAPES}b.ngc"), b"not-utf8-\xff\x9b2J.ngc", b"two\nlines.ngc"]
        texts = [SQUARE, f"(MSG,{ESCAPES}<script>)\nG1 X1 F{ESCAPES}\n\x1b]0;title\x07\nG1 X1 (\x1b\nM2\n", f"G21 ({ESCAPES})\nG1 X1 F100\nM2\n"]
        for name in names:
            for text in texts:
                path = os.path.join(folder, name)
                with open(path, "wb") as file:
                    file.write(text.encode())
                for words in (["check"], ["check", "--json"], ["check", "--format", "json"], ["check", "--format", "sarif"], ["dry-run"],
                              ["explain", "--line", "1"], ["check", "--machine", path], ["check", "--tools", path]):
                    done = subprocess.run([KERF, *words, path], capture_output=True, timeout=60)
                    for stream in (done.stdout, done.stderr):
                        shown = stream.decode()  # UTF-8, always
                        hidden = [c for c in shown if c != "\n" and (c < " " or "\x7f" <= c <= "\x9f")]
                        self.assertEqual(hidden, [], (words, name, stream))
                        self.assertNotIn("\nlines.ngc", shown)
                    if "json" in words or "--json" in words or "sarif" in words:
                        json.loads(done.stdout)
        self.assertIn("\\x1B[31m\\x07\\xC2\\x9B2J", subprocess.run([KERF, "check", os.path.join(folder, b"none\x1b[31m\x07\xc2\x9b2J")],
                                                                    capture_output=True, timeout=60).stderr.decode())
        done = subprocess.run([KERF, b"\x1b[2J"], capture_output=True, timeout=60)
        self.assertEqual((done.returncode, b"\x1b" in done.stderr), (2, False))

    def test_row_30_only_a_regular_file_is_a_program(self):
        fifo = self.path("fifo")
        os.mkfifo(fifo)
        for path in (fifo, "/dev/zero", "/dev/null", str(self.folder)):
            for command in ("check", "dry-run"):
                with self.subTest(path=path, command=command):
                    self.assertIn(path, self.kerf(command, path, status=5).stderr)
        packed = self.path("bomb.ngc.gz")
        with gzip.open(packed, "wb") as file:
            file.write(b"G0 X1\n" * 1_000_000)
        self.kerf("check", packed, status=1)

    # The clock

    def test_row_74_a_stopped_process_is_a_fault(self):
        trace = self.path("t.csv")
        process = self.start("run", self.path("long.ngc", LONG), "--trace", trace, "--json")
        self.wait_for_bytes(trace + ".incomplete", 100_000, process)
        process.send_signal(signal.SIGSTOP)
        time.sleep(1.5)
        process.send_signal(signal.SIGCONT)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 4, err)
        gap = re.search(r"machine fault: no tick for ([\d.]+) s, in line 3, at 0:00:0", err)
        self.assertTrue(gap, err)
        self.assertGreaterEqual(float(gap[1]), 1.4)
        report = json.loads(out)
        self.assertEqual((report["exit_status"], report["fault"]["kind"], report["fault"]["line"]), (4, "no_tick", 3))

    # Files and streams that are written

    def test_row_75_a_full_disk_ends_a_dry_run_and_marks_what_is_there(self):
        program, trace = self.path("long.ngc", LONG), self.path("t.csv")
        done = self.limited(["dry-run", program, "--trace", trace], RLIMIT_FSIZE=1_000_000)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("File too large", done.stderr)
        self.assertFalse(os.path.exists(trace))
        self.assertEqual(os.path.getsize(trace + ".incomplete"), 1_000_000)
        self.assertEqual(self.kerf("dry-run", program, "--trace", "/dev/full", status=5).stdout.count("input or output failed"), 1)
        for words in (["--json"], []):
            with open("/dev/full", "w") as full:
                self.assertEqual(subprocess.run([KERF, "check", program, *words], stdout=full, stderr=subprocess.PIPE).returncode, 5)

    def test_row_75_a_full_disk_does_not_stop_a_run(self):
        program, trace = self.path("square.ngc", SQUARE), self.path("t.csv")
        done = self.limited(["run", program, "--trace", trace], RLIMIT_FSIZE=10_000)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("path            80.000 mm", done.stdout)
        self.assertEqual(os.listdir(self.folder).count("t.csv"), 0)

    def test_row_76_a_reader_that_has_seen_enough_ends_a_dry_run_quietly(self):
        process = self.start("dry-run", self.path("long.ngc", LONG), "--trace", "-")
        self.assertTrue(process.stdout.readline().startswith("t_s,"))
        process.stdout.close()
        with process.stderr as err:
            self.assertEqual(err.read(), "")
        self.assertEqual(process.wait(timeout=60), 0)

    def test_row_76_a_slow_reader_does_not_stop_a_run(self):
        reading, writing = os.pipe()
        slow = self.path("slow.ngc", "G21 G90\nF1200\nG1 X60\nM30\n")  # 3 s, more than a pipe holds
        process = self.start("run", slow, "--trace", "-", stdout=writing)
        os.close(writing)
        time.sleep(4.5)  # by then it is over
        with os.fdopen(reading) as pipe:
            rows = pipe.read().splitlines()
        err = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 0, err)
        self.assertIn("path            60.000 mm", err)
        self.assertGreater(len(rows), 3000)
        self.assertEqual(float(rows[-1].split(",")[6]), 60.0)

    def test_row_76_a_reader_that_stalls_does_not_keep_a_dry_run_from_ending(self):
        for number, status in ((signal.SIGTERM, 143), (signal.SIGINT, 130), (signal.SIGHUP, 129)):
            reading, writing = os.pipe()
            process = self.start("dry-run", self.path("long.ngc", LONG), "--trace", "-", stdout=writing)
            os.close(writing)
            time.sleep(0.7)
            process.send_signal(number)  # the first is enough
            process.communicate(timeout=30)
            os.close(reading)
            self.assertEqual(process.returncode, status)

    # Signals

    def test_row_77_the_first_signal_stops_on_the_path_and_the_second_at_once(self):
        for number, status in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            trace = self.path("t.csv")
            process = self.start("run", self.path("long.ngc", LONG), "--trace", trace)
            self.wait_for_bytes(trace + ".incomplete", 1, process)
            process.send_signal(number)
            out = process.communicate(timeout=60)[0]
            self.assertEqual(process.returncode, status)
            self.assertIn("stopped on the path, as asked for", out)
            with open(trace) as file:
                last = file.read().splitlines()[-1].split(",")
            self.assertEqual(float(last[3]), 0.0)  # at rest

    def test_row_77_a_dry_run_that_is_stopped_leaves_its_trace_marked(self):
        trace = self.path("t.csv")
        process = self.start("dry-run", self.path("long.ngc", LONG), "--trace", trace, "--max-trace", "100GiB")
        self.wait_for_bytes(trace + ".incomplete", 100_000, process)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 143)
        self.assertEqual(sorted(os.listdir(self.folder)), ["long.ngc", "t.csv.incomplete"])

    def test_row_77_what_a_kill_leaves_is_marked_and_the_next_start_says_so(self):
        program, trace, plot = self.path("long.ngc", LONG), self.path("t.csv"), self.path("p.svg")
        process = self.start("run", program, "--trace", trace, "--plot", plot)
        self.wait_for_bytes(trace + ".incomplete", 100_000, process)
        process.kill()
        process.communicate(timeout=60)
        self.assertEqual(sorted(os.listdir(self.folder)), ["long.ngc", "p.svg.incomplete", "t.csv.incomplete"])
        done = self.kerf("dry-run", self.path("square.ngc", SQUARE), "--trace", trace, "--plot", plot)
        for name in (trace, plot):
            self.assertIn(f"an earlier run did not end cleanly: its {name}.incomplete is replaced", done.stdout)
        self.assertEqual(sorted(os.listdir(self.folder)), ["long.ngc", "p.svg", "square.ngc", "t.csv"])
        self.assertNotIn("cleanly", self.kerf("dry-run", program.replace("long", "square"), "--trace", trace).stdout)

    # The system around it

    def test_row_78_without_memory_or_threads_nothing_moves(self):
        if b"__asan_init" in pathlib.Path(KERF).read_bytes():
            self.skipTest("a sanitizer asks for memory of its own")
        square = self.path("square.ngc", SQUARE)
        seen = set()
        for mega in (16, 18, 20, 22, 24, 28, 32, 64, 128):
            for words in (["--version"], ["check", square], ["run", square, "--trace", self.path("t.csv")]):
                done = self.limited(words, RLIMIT_AS=mega << 20)
                if done.returncode == 127:
                    break  # not even the system's own loader has enough
                seen.add(done.returncode)
                self.assertIn(done.returncode, (0, 5), (mega, words, done.stderr))
                if done.returncode == 5:
                    self.assertIn("the system refuses what is needed", done.stderr)
                    self.assertEqual(done.stdout, "")
        self.assertIn(0, seen)

    def test_row_78_without_descriptors_nothing_moves(self):
        square = self.path("square.ngc", SQUARE)
        done = self.limited(["run", square, "--trace", self.path("t.csv")], RLIMIT_NOFILE=4)
        if "invalid vptr" in done.stderr:
            self.skipTest("a sanitizer takes a descriptor to look at memory")
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("Too many open files", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_row_80_the_same_bytes_in_every_locale(self):
        program = os.path.join(SOURCE, "programs/polygon.ngc")
        plain = {name: value for name, value in os.environ.items() if not name.startswith("LC_") and name not in ("LANG", "TZ")}
        places = [{}, {"LC_ALL": "C"}, {"LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}, {"TZ": "Asia/Kathmandu"}, {"LC_NUMERIC": "de_DE.UTF-8"}]
        compiled = shutil.which("localedef") and subprocess.run(
            ["localedef", "-i", "de_DE", "-f", "UTF-8", self.path("de_DE.UTF-8")], capture_output=True).returncode == 0
        if compiled:  # else the locale of the system, if it has it
            places = [{**place, "LOCPATH": str(self.folder)} for place in places]
        answers = []
        for place in places:
            trace, plot = self.path("t.csv"), self.path("p.svg")
            done = self.kerf("dry-run", program, "--trace", trace, "--plot", plot, env={**plain, **place})
            report = json.loads(self.kerf("dry-run", program, "--json", env={**plain, **place}).stdout)
            del report["elapsed"]
            answers.append((done.stdout, pathlib.Path(trace).read_bytes(), pathlib.Path(plot).read_bytes(), report))
        for answer in answers[1:]:
            self.assertEqual(answer, answers[0])


if __name__ == "__main__":
    main(at_once=2)
