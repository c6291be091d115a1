#!/usr/bin/env python3
"""What `kerf report` and `kerf view` write, without a browser: the page around the plans, and what the plans say."""
import base64
import json
import math
import os
import pathlib
import re
import subprocess
import time
import zlib

from command_line import Case, KERF, SOURCE, SQUARE, TOO_FAR, WRONG, main

TEMPLATE = "<!doctype html><title>t</title>\n<!-- plans of version 2 -->\n<p>end</p>\n"
PLAN = re.compile(r'<script type="application/x-kerf-plan">([^<]*)</script>')
HOSTILE = "G21 G90 F3000\n(</script><script>alert`1`</script>)\n(MSG, <img src=x onerror=alert`2`>)\nG1 X1\nM30\n"


def plans_of(path):
    """(header, sections by name) of each plan of a page."""
    found = []
    for packed in PLAN.findall(pathlib.Path(path).read_text()):
        data = zlib.decompress(base64.b64decode(packed, validate=True))
        assert data[:8] == b"KERFPLAN"
        size = int.from_bytes(data[8:12], "little")
        header = json.loads(data[12:12 + size])
        at = 12 + size
        sections = {}
        for section in header["sections"]:
            part = data[at:at + section["bytes"]]
            at += section["bytes"]
            sections[section["name"]] = part if section["coding"] == "bytes" else unpacked(part, section["unit"])
        assert at == len(data)
        found.append((header, sections))
    return found


def unpacked(data, unit):
    numbers, last, step, shift = [], 0, 0, 0
    for byte in data:
        step |= (byte & 0x7F) << shift
        shift += 7
        if byte < 0x80:
            last += (step >> 1) ^ -(step & 1)
            numbers.append(last * unit)
            step = shift = 0
    return numbers


class Report(Case):
    def setUp(self):
        super().setUp()
        self.template = self.path("template.html", TEMPLATE)
        self.page = self.path("part.html")

    def report(self, *words, **more):
        return self.kerf("report", *words, "-o", self.page, "--page", self.template, **more)

    def test_puts_a_program_and_its_run_between_the_halves_of_the_page(self):
        self.report(self.path("square.ngc", SQUARE))
        text = pathlib.Path(self.page).read_text()
        self.assertTrue(text.startswith(TEMPLATE.split("<!--")[0]))
        self.assertTrue(text.endswith("\n<p>end</p>\n"))
        [(header, sections)] = plans_of(self.page)
        self.assertEqual(header["version"], 2)
        self.assertEqual(sections["source"].decode(), SQUARE)
        self.assertEqual(header["report"]["command"], "report")
        dry = json.loads(self.kerf("dry-run", "--json", "--explain-speed", self.path("square.ngc")).stdout)
        for key in ("cycle_time_s", "ticks", "path_length_mm", "blocks", "extents", "max", "speed_limits"):
            self.assertEqual(header["report"][key], dry[key], key)

    def test_has_the_ticks_of_the_trace(self):
        program = self.path("square.ngc", SQUARE)
        self.report(program)
        self.kerf("dry-run", "-q", program, "--trace", self.path("trace.csv"))
        rows = [line.split(",") for line in pathlib.Path(self.path("trace.csv")).read_text().splitlines()[1:]]
        [(header, sections)] = plans_of(self.page)
        self.assertEqual(header["columns"], len(rows))
        self.assertEqual(header["last_tick"], len(rows) - 1)
        for column, name in ((3, "path.v"), (4, "path.a"), (5, "path.j")):
            most = max(abs(float(row[column])) for row in rows)
            for row, value in zip(rows, sections[name]):
                self.assertAlmostEqual(float(row[column]), value, delta=2e-7 * most + 1e-6)
        # The place of the tool at each tick, between the points of the path.
        ticks = sections["path.tick"]
        for k, axis in enumerate("xyz"):
            at = 0
            for tick, row in enumerate(rows):
                while at + 2 < len(ticks) and ticks[at + 1] < tick:
                    at += 1
                a, b = sections["path." + axis][at:at + 2]
                share = (tick - ticks[at]) / (ticks[at + 1] - ticks[at])
                self.assertAlmostEqual(float(row[6 + k]), a + share * (b - a), delta=header["path_tolerance_mm"] + 1e-6)
        begins = sections["runs.tick"]
        for begin, line in zip(begins, sections["runs.line"]):
            self.assertEqual(int(rows[int(begin)][1]), line)

    def test_of_a_million_lines_takes_less_than_25_megabytes(self):
        # A rose of three petals over and over, in lines of a tenth of a millimetre; the page itself is one megabyte.
        text = "G21 G90 G64 P0.01 Q0.01 F6000\n" + "".join(
            f"G1 X{80 * math.sin(u * 3) * math.cos(u):.3f} Y{80 * math.sin(u * 3) * math.sin(u):.3f}\n"
            for u in (i * 6e-4 for i in range(1_000_000))) + "M2\n"
        self.report(self.path("rose.ngc", text))
        self.assertLess(os.path.getsize(self.page), 24_000_000)
        self.assertGreater(os.path.getsize(self.page), 1_000_000)

    def test_has_nothing_of_a_program_but_base64(self):
        name = self.path("<script>alert`3`<", HOSTILE)
        self.report(name)
        text = pathlib.Path(self.page).read_text()
        self.assertNotIn("alert", text)
        self.assertEqual(text.count("<script"), 1)
        self.assertEqual(plans_of(self.page)[0][1]["source"].decode(), HOSTILE)

    def test_takes_the_end_of_a_rapid_for_no_cut(self):
        text = "G21 G90 G61\nG0 X30 Y30\nG1 F1200 X40\nG4 P0.1\nG0 X-40 Y-40\nG4 P0.1\nM2\n"
        self.report(self.path("far.ngc", text))
        [(_, sections)] = plans_of(self.page)
        x, rapid = sections["path.x"], sections["path.rapid"]
        cut = [place for i in range(1, len(x)) if not rapid[i] for place in (x[i - 1], x[i])]
        self.assertAlmostEqual(min(cut), 30, delta=1e-3)
        self.assertAlmostEqual(max(cut), 40, delta=1e-3)

    def test_leaves_all_of_the_text_out_where_that_is_asked_for(self):
        for text, status in ("(MSG, secret)\n(secret)\nG1 F100 X1\n; secret\nG1 X2\n", 0), ("G1 F100 X1 (secret)\nG1 G2 X2 (secret)\n", 1), ("G1 F100 X1\n(ABORT, secret)\nM2\n", 1), ("o1 if [1] G1 X1 secret\no1 endif\nM2\n", 1):
            self.report("--no-source", self.path("hidden.ngc", text), status=status)
            [(header, sections)] = plans_of(self.page)
            self.assertNotIn("secret", json.dumps(header))
            self.assertFalse([name for name, part in sections.items() if isinstance(part, bytes) and b"secret" in part])

    def test_leaves_the_words_of_an_alarm_and_names_out_of_its_messages(self):
        for text, dialect, id in (("O1\nG0 X1.\n#3000=1(SECRET)\nM30\n", "fanuc", "E0543"), ("G0 X#<secret>\nM2\n", "rs274", "E0404"),
                                  ("o<secret> call\nM2\n", "rs274", "E0511")):
            self.report("--no-source", "--dialect", dialect, self.path("hidden.ngc", text), status=1)
            [(header, _)] = plans_of(self.page)
            self.assertEqual([one["id"] for one in header["diagnostics"]], [id])
            self.assertNotIn("secret", json.dumps(header).lower())

    def test_names_no_folder_of_a_subprogram_that_is_not_read(self):
        folder = pathlib.Path(self.path("calls.ngc", "o<linked> call\nM2\n")).parent
        (folder / "linked.ngc").symlink_to("/etc/passwd")
        self.report(str(folder / "calls.ngc"), status=1)
        [(header, _)] = plans_of(self.page)
        self.assertIn("linked.ngc is not read", header["diagnostics"][0]["message"])
        self.assertNotIn(str(folder), json.dumps(header))

    def test_leaves_the_text_out_where_that_is_asked_for(self):
        program = self.path("square.ngc", SQUARE)
        self.assertIn("with the program's text", self.report(program).stderr)
        self.assertIn("without the program's text", self.report("--no-source", program).stderr)
        [(header, sections)] = plans_of(self.page)
        self.assertFalse(header["has_source"])
        self.assertNotIn("source", sections)

    def test_shows_errors_without_the_text_where_that_is_asked_for(self):
        self.report("--no-source", self.path("wrong.ngc", WRONG), status=1)
        [(header, sections)] = plans_of(self.page)
        self.assertFalse(header["has_source"])
        self.assertNotIn("source", sections)
        self.assertEqual({one["line"] for one in header["diagnostics"]}, {3, 5})

    def test_sets_programs_and_machines_side_by_side(self):
        machines = [SOURCE + "/programs/machines/" + name for name in ("table.toml", "sigmoid-wm.toml")]
        programs = [self.path("square.ngc", SQUARE), self.path("other.ngc", SQUARE.replace("20", "30"))]
        self.report("-q", *programs, "--machine", machines[0], "--machine", machines[1])
        found = [(header["report"]["file"], header["report"]["machine"]) for header, _ in plans_of(self.page)]
        names = [[pathlib.Path(one).name for one in of] for of in (programs, machines)]
        self.assertEqual(found, [(program, machine) for program in names[0] for machine in names[1]])

    def test_shows_errors_of_a_program_that_does_not_run(self):
        self.report(self.path("wrong.ngc", WRONG), status=1)
        [(header, sections)] = plans_of(self.page)
        asked = self.kerf("dry-run", "--format", "json", self.path("wrong.ngc"), status=1).stderr
        expected = [{**one, "file": "wrong.ngc"} for one in json.loads(asked)["diagnostics"]]
        self.assertEqual(header["diagnostics"], expected)
        self.assertEqual({one["line"] for one in header["diagnostics"]}, {3, 5})
        self.assertNotIn("last_tick", header)
        self.assertEqual(sections["source"].decode(), WRONG)

    def test_says_how_far_a_program_leaves_the_travel(self):
        self.report(self.path("far.ngc", TOO_FAR), status=4)
        [(header, _)] = plans_of(self.page)
        self.assertEqual(header["extents"]["max_mm"][0], 1000.0)
        self.assertEqual(header["machine"]["axes"][0]["travel"], [-500.0, 500.0])

    def test_names_files_without_the_folders_that_they_lie_in(self):
        program = self.path("part.ngc", "G21 G90 F600\no<drill> call\nG1 X10\nM30\n")
        self.path("drill.ngc", "o<drill> sub\nG1 X1 F-3\no<drill> endsub\n")
        machine = self.path("mill.toml", (pathlib.Path(SOURCE) / "programs/machines/table.toml").read_text())
        self.report(program, "--machine", machine, status=1)
        [(header, _)] = plans_of(self.page)
        self.assertEqual((header["report"]["file"], header["report"]["machine"]), ("part.ngc", "mill.toml"))
        self.assertEqual({one["file"] for one in header["diagnostics"]}, {"drill.ngc"})
        self.assertNotIn(str(pathlib.Path(program).parent), json.dumps(header))

    def test_writes_to_standard_output(self):
        done = self.kerf("report", self.path("square.ngc", SQUARE), "-o", "-", "--page", self.template)
        self.assertEqual(len(PLAN.findall(done.stdout)), 1)
        self.assertTrue(done.stdout.endswith("<p>end</p>\n"))

    def test_says_what_is_missing(self):
        program = self.path("square.ngc", SQUARE)
        self.assertIn("none.html", self.kerf("report", program, "-o", self.page, "--page", self.path("none.html"), status=5).stderr)
        other = self.path("other.html", "<!-- plans of version 99 -->")
        self.assertIn("version", self.kerf("report", program, "-o", self.page, "--page", other, status=5).stderr)
        self.assertIn("nowhere", self.kerf("report", program, "-o", self.path("nowhere/x.html"), "--page", self.template, status=5).stderr)
        self.report(self.path("none.ngc"), status=5)
        self.assertFalse(os.path.exists(self.page))
        self.kerf("report", program, status=2)  # no -o
        self.kerf("report", "-", "-o", self.page, "--machine", "a", "--machine", "b", status=2, stdin=SQUARE)

    def test_leaves_the_page_without_data_as_it_is(self):
        program = self.path("square.ngc", SQUARE)
        self.assertIn("not to be written over", self.kerf("report", program, "-o", self.template, "--page", self.template, status=2).stderr)
        copy, beside = self.path("kerf"), self.path("page.html", TEMPLATE)
        pathlib.Path(copy).write_bytes(pathlib.Path(KERF).read_bytes())
        os.chmod(copy, 0o755)
        done = subprocess.run([copy, "report", program, "-o", beside], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertIn("not to be written over", done.stderr)
        for path in (self.template, beside):
            self.assertEqual(pathlib.Path(path).read_text(), TEMPLATE)

    def test_ends_where_rapids_begin_and_end_everywhere(self):
        self.report(self.path("dots.ngc", "G21 G90 G61 F3000\n#1=0\nG91\no1 while [#1 LT 80000]\nG0 X0.003\nG1 X0.003\n#1=[#1+1]\no1 endwhile\nM2\n"))
        [(_, sections)] = plans_of(self.page)
        self.assertGreater(len(sections["path.tick"]), 1000)

    def test_names_the_place_of_the_page_where_it_is_in_none(self):
        copy = self.path("kerf")
        pathlib.Path(copy).write_bytes(pathlib.Path(KERF).read_bytes())
        os.chmod(copy, 0o755)
        done = subprocess.run([copy, "report", self.path("square.ngc", SQUARE), "-o", self.page], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 5)
        self.assertIn("page.html", done.stderr)
        self.assertIn("./kerf report", done.stderr)
        self.path("page.html", TEMPLATE)
        subprocess.run([copy, "report", "-q", self.path("square.ngc"), "-o", self.page], check=True)


class View(Case):
    def test_says_where_the_page_is_where_there_is_no_desktop(self):
        template = self.path("template.html", TEMPLATE)
        env = {"TMPDIR": str(self.folder), "PATH": os.environ["PATH"]}
        done = self.kerf("view", "-q", self.path("square.ngc", SQUARE), "--page", template, env=env)
        page = re.match(r"(.*/square\.html): ", done.stderr).group(1)
        self.assertEqual(pathlib.Path(page).parent.parent, self.folder)
        self.assertEqual(len(plans_of(page)), 1)

    def test_leaves_no_folder_where_there_is_no_page(self):
        folder = self.folder / "temporary"
        folder.mkdir()
        env = {"TMPDIR": str(folder), "PATH": os.environ["PATH"]}
        template = self.path("template.html", TEMPLATE)
        self.kerf("view", "-q", self.path("none.ngc"), "--page", template, env=env, status=5)
        self.kerf("view", "-q", self.path("square.ngc", SQUARE), "--page", self.path("other.html", "<html>"), env=env, status=5)
        self.assertEqual(list(folder.iterdir()), [])

    def test_shows_the_page_in_the_desktops_browser(self):
        opener = self.path("xdg-open", f"#!/bin/sh\necho \"$1\" >'{self.folder}/asked'\nmv '{self.folder}/asked' '{self.folder}/opened'\n")
        os.chmod(opener, 0o755)
        env = {"TMPDIR": str(self.folder), "PATH": str(self.folder) + ":" + os.environ["PATH"], "DISPLAY": ":7"}
        self.kerf("view", "-q", self.path("square.ngc", SQUARE), "--page", self.path("template.html", TEMPLATE), env=env)
        opened = self.folder / "opened"
        for _ in range(500):
            if opened.exists():
                break
            time.sleep(0.02)
        self.assertEqual(len(plans_of(opened.read_text().strip())), 1)


if __name__ == "__main__":
    main()
