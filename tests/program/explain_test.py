#!/usr/bin/env python3
"""`kerf explain`: what is in force at a line, and when."""
import csv
import json
import pathlib

from command_line import Case, SOURCE, SQUARE, main


class Explain(Case):
    def test_outputs_at_motion_take_no_time_and_a_tool_of_no_length_is_in_force(self):
        program = self.path("out.ngc", "G1 X10 F600\nM62 P1\nG1 X20\nT2 M6\nG43 H2\nG0 X0\nM2\n")
        trace = self.path("out.csv")
        self.kerf("dry-run", program, "--trace", trace, "-q")
        with open(trace) as file:
            rapid = [float(row["t_s"]) for row in csv.DictReader(file) if int(row["line"]) == 6]
        told = json.loads(self.kerf("explain", program, "--line", "6", "--json").stdout)["block"]
        self.assertAlmostEqual(told["begin_s"], rapid[0], delta=0.0011)
        self.assertIn("G43", told["codes"])

    def test_outputs_and_what_overrides_are_for_are_shown_as_at_a_start_at_the_line(self):
        path = self.path("o.ngc", "G21 G90 F600\nM62 P1\nG1 X1\nM64 P3\nM65 P1\nM68 E0 Q2.5\nM49\nM52 P1\nG1 X5\nM48\nM67 E0 Q0\nM53 P0\nG1 X9\nM2\n")
        block = json.loads(self.kerf("explain", path, "--line", "9", "--json").stdout)["block"]
        self.assertEqual(block["outputs"], {"digital_on": [3], "analog": [2.5, 0, 0, 0, 0, 0, 0, 0]})
        self.assertEqual([code for code in block["codes"] if code.startswith("M5") and code != "M5"], ["M50 P0", "M51 P0", "M52"])
        self.assertIn("  outputs         P3 on, E0 2.5\n", self.kerf("explain", path, "--line", "9").stdout)
        start = json.loads(self.kerf("dry-run", path, "--from-line", "9", "--json", "-q").stdout)["start"]
        self.assertEqual((start["outputs"], start["codes"]), (block["outputs"], block["codes"]))
        block = json.loads(self.kerf("explain", path, "--line", "13", "--json").stdout)["block"]
        self.assertEqual(block["outputs"], {"digital_on": [3], "analog": [0] * 8})
        self.assertEqual([code for code in block["codes"] if code.startswith("M5") and code != "M5"], ["M52", "M53 P0"])
        self.assertEqual(json.loads(self.kerf("explain", path, "--line", "3", "--json").stdout)["block"]["outputs"]["digital_on"], [1])

    def test_tells_the_tolerances_of_g64(self):
        program = self.path("g64.ngc", "G64 P0.02 Q0.005\nG1 X10 F600\nG20 G64 P0.01\nX1\nG61\nX2\nM2\n")
        self.assertIn("  G64             P 0.02, Q 0.005 mm\n", self.kerf("explain", program, "--line", "2").stdout)
        for line, corner, merge in ((2, 0.02, 0.005), (4, 0.254, 0.254), (6, 0.0, 0.0)):
            told = self.explained(program, line)
            self.assertAlmostEqual(told["corner_tolerance_mm"], corner)
            self.assertAlmostEqual(told["merge_tolerance_mm"], merge)

    def test_finds_the_time_that_the_trace_of_a_run_has(self):
        for name, step in (("pocket.ngc", 7), ("raster.ngc", 700)):
            self.compare_with_trace(str(pathlib.Path(SOURCE) / "programs" / name), step)

    def test_finds_the_time_of_moves_that_compensation_holds_back(self):
        program = self.path("held.ngc", "G21 G90 F600\nG0 X-20 Y-20\nG41.1 D4 G1 X0 Y0\nY30\nX30\nG2 X40 Y20 J-10\n"
                                        "(beside)\nG1 Y0\nG40 X60 Y-20\nX80\nM2\n")
        self.compare_with_trace(program, 1)
        self.assertEqual(self.explained(program, 7)["begin_s"], self.explained(program, 8)["begin_s"])
        for line, code in ((3, "G40"), (4, "G41.1"), (10, "G40")):
            self.assertIn(code, self.explained(program, line)["codes"])

    def test_shows_what_shapes_a_fanuc_program(self):
        program = self.path("shaped.nc", "G0 X1\nG51.1 X0\nG51 X0 Y0 P2.\nG68 X0 Y0 R90\nG0 X2\nG69\nG50\nG50.1\nG0 X3\nM30\n")
        shaped = self.explained(program, 5, "--dialect", "fanuc")["codes"]
        for code in ("G51.1", "G51", "G68"):
            self.assertIn(code, shaped)
        plain = self.explained(program, 9, "--dialect", "fanuc")["codes"]
        for code in ("G51.1", "G51", "G68"):
            self.assertNotIn(code, plain)

    def compare_with_trace(self, program, step):
        trace = self.path("t.csv")
        self.kerf("dry-run", program, "--trace", trace, "-q")
        with open(trace) as file:
            rows = [(float(row["t_s"]), int(row["line"])) for row in csv.DictReader(file)]
        lines = sorted({line for _, line in rows})
        for line in lines[2:-1:step]:
            with self.subTest(program=program, line=line):
                block = json.loads(self.kerf("explain", program, "--line", str(line), "--json").stdout)["block"]
                times = [t for t, at in rows if at == line]
                # A tick belongs to the phase that holds its instant.
                self.assertLess(abs(times[0] - block["begin_s"]), 0.0011)
                self.assertLess(abs(times[-1] - times[0] - block["duration_s"]), 0.0021)

    def test_shows_what_is_in_force_before_the_line(self):
        path = self.path("modes.ngc", "G21 G90 G18\nG1 X1 F600\nG91 G2 X2 I1\nM3 S500\nG0 X3\nM30\n")
        block = json.loads(self.kerf("explain", path, "--line", "3", "--json").stdout)["block"]
        self.assertEqual(block["text"], "G91 G2 X2 I1")
        self.assertEqual(block["position_mm"], {"x": 1.0, "y": 0.0, "z": 0.0})
        for code in ("G1", "G18", "G90", "G94", "M5"):
            self.assertIn(code, block["codes"])
        block = json.loads(self.kerf("explain", path, "--line", "5", "--json").stdout)["block"]
        for code in ("G2", "G91", "M3"):
            self.assertIn(code, block["codes"])
        self.assertEqual(block["spindle_speed"], 500.0)
        self.assertEqual(block["position_mm"]["x"], 3.0)

    def test_shows_the_feed_of_a_turn(self):
        path = self.path("turn.ngc", "G21 G90 G95 S1000 M3\nG1 X10 F0.2\nX20\nG94 F600\nX30\nM30\n")
        for line, per_turn, feedrate, text in ((3, 0.2, None, " 0.2 mm/rev"), (5, None, 10.0, " 600 mm/min")):
            block = json.loads(self.kerf("explain", path, "--line", str(line), "--json").stdout)["block"]
            self.assertEqual((block["feed_mm_rev"], block["feedrate_mm_s"]), (per_turn, feedrate))
            self.assertIn(text, self.kerf("explain", path, "--line", str(line)).stdout)

    def test_shows_the_offsets_in_force(self):
        path = self.path("offsets.ngc", "G21 G90\nG10 L2 P2 X10 Y20 Z0 R90\nG55 T1 M6\nG43.1 Z12.5\nM8\nG0 X1 Y2 Z3\nM30\n")
        block = json.loads(self.kerf("explain", path, "--line", "7", "--json").stdout)["block"]
        for code in ("G55", "G43", "M8", "G97"):
            self.assertIn(code, block["codes"])
        # Turned by a quarter: X of the program is Y of the machine, Y is -X.
        for axis, value in (("x", 10 - 2), ("y", 20 + 1), ("z", 3 + 12.5)):
            self.assertAlmostEqual(block["position_mm"][axis], value)
        self.assertAlmostEqual(block["program_position_mm"]["y"], 2.0)
        self.assertEqual((block["tool"], block["tool_offset_mm"]["z"]), (1, 12.5))
        text = self.kerf("explain", path, "--line", "7").stdout
        self.assertIn("x 8.000, y 21.000, z 15.500 mm on the machine", text)
        self.assertIn("turned by 90 degrees", text)

    def test_counts_dwells_and_events_as_time_of_their_line(self):
        path = self.path("dwell.ngc", "G21 G90\nG1 X1 F600\nG4 P0.5\nG4 P0.25\nM3 S1\nG90\nG1 X2\nM30\n")
        blocks = [json.loads(self.kerf("explain", path, "--line", str(line), "--json").stdout)["block"]
                  for line in (3, 4, 5, 6, 7)]
        self.assertAlmostEqual(blocks[0]["duration_s"], 0.5)
        self.assertAlmostEqual(blocks[1]["begin_s"] - blocks[0]["begin_s"], 0.5)
        self.assertAlmostEqual(blocks[1]["duration_s"], 0.25)
        for block in blocks[2:]:
            self.assertAlmostEqual(block["begin_s"] - blocks[1]["begin_s"], 0.25)
        self.assertEqual(blocks[3]["duration_s"], 0.0)

    def test_counts_the_first_pass_of_a_loop_alone(self):
        moves = self.path("loop.ngc", "G21 G91 G61.1 F600\no1 repeat [3]\nG1 X10\no1 endrepeat\nG1 X10\nM2\n")
        first, behind = self.explained(moves, 3), self.explained(moves, 5)
        self.assertAlmostEqual(first["duration_s"], behind["duration_s"])  # each pass is such a line
        self.assertAlmostEqual(behind["begin_s"] - first["begin_s"], 3 * first["duration_s"], delta=0.005)
        rests = self.path("rests.ngc", "G21\no1 repeat [3]\nG4 P1\no1 endrepeat\nM2\n")
        self.assertAlmostEqual(self.explained(rests, 3)["duration_s"], 1.0)
        calls = self.path("calls.nc", "O1\nG21 G91 G61.1 F600\nM98 P7 L3\nM30\nO7\nG1 X10\nM99\n")
        self.assertAlmostEqual(self.explained(calls, 6, "--dialect", "fanuc")["duration_s"], first["duration_s"], delta=0.002)

    def test_counts_all_that_a_call_of_another_file_runs(self):
        self.path("there.ngc", "o<there> sub\nG1 X10\nX20\no<there> endsub\n")
        path = self.path("call.ngc", "G21 G90 G61.1 F600\no<there> call\nG1 X30\nM2\n")
        self.assertAlmostEqual(self.explained(path, 2)["duration_s"], 2 * self.explained(path, 3)["duration_s"], delta=0.003)

    def explained(self, path, line, *words):
        return json.loads(self.kerf("explain", path, "--line", str(line), "--json", *words).stdout)["block"]

    def test_knows_when_a_statement_was_first_reached(self):
        path = self.path("flow.ngc", "o<a> sub\nG0 X#1\no<a> endsub\nG21 G90\n#1=1\no1 while [#1 LT 3]\n"
                                     "o<a> call [#1]\n#1=[#1+1]\no1 endwhile\no2 if [0]\no2 elseif [1]\no2 endif\nM2\n")
        for line, text, x in ((1, "o<a> sub", 0.0), (3, "o<a> endsub", 1.0), (6, "o1 while [#1 LT 3]", 0.0),
                              (7, "o<a> call [#1]", 0.0), (9, "o1 endwhile", 1.0), (10, "o2 if [0]", 2.0),
                              (11, "o2 elseif [1]", 2.0), (12, "o2 endif", 2.0)):
            block = self.explained(path, line)
            self.assertEqual((block["text"], block["position_mm"]["x"]), (text, x))
        path = self.path("macro.nc", "O1 (MAIN)\n#1=1\nWHILE [#1 LE 2] DO1\nG0 X#1\n#1=#1+1\nEND1\n"
                                     "IF [#1 EQ 3] THEN #2=7\nIF [#1 EQ 3] GOTO 9\nGOTO 1\nN9 M30\n")
        for line, text, x in ((1, "O1 (MAIN)", 0.0), (3, "WHILE [#1 LE 2] DO1", 0.0), (6, "END1", 1.0),
                              (7, "IF [#1 EQ 3] THEN #2=7", 2.0), (8, "IF [#1 EQ 3] GOTO 9", 2.0)):
            block = self.explained(path, line, "--dialect", "fanuc")
            self.assertEqual((block["text"], block["position_mm"]["x"]), (text, x))
        said = self.kerf("explain", path, "--line", "9", "--dialect", "fanuc", status=1).stderr
        self.assertIn("line 9 is never run", said)

    def test_says_so_where_a_line_is_never_run(self):
        path = self.path("square.ngc", SQUARE)
        self.assertIn("line 99 is never run", self.kerf("explain", path, "--line", "99", status=1).stderr)
        self.kerf("explain", path, status=2)


if __name__ == "__main__":
    main()
