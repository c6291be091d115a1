#!/usr/bin/env python3
"""A start at every line of every shipped program: TEST.py KERF SOURCE_DIR LINE_STATES

What it shows is what `explain` says, what LinuxCNC has in force there (linuxcnc/), and where the tool of a dry run is.
"""
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import comparison  # noqa: E402
import golden  # noqa: E402

KERF, SOURCE, LINE_STATES = sys.argv[1:4]
PROGRAMS = sorted((pathlib.Path(SOURCE) / "programs").glob("*.ngc"))
MACHINE = f"{SOURCE}/programs/machines/table.toml"
# A start in a long program takes as long as reading it; what `explain` says is compared at each of its lines all the same.
STEP = {"raster": 8}


class EveryLine(unittest.TestCase):
    def judge(self, program, folder):
        """How many lines were compared: of starts with explain, with LinuxCNC, with ticks."""
        states = comparison.kerf_states(LINE_STATES, program, MACHINE, "rs274", STEP.get(program.stem, 1))
        linuxcnc = golden.states_of((golden.FOLDER / f"{program.stem}.states").read_text(encoding="ascii"))
        ticks = comparison.ticks_of(KERF, program, MACHINE, "rs274", f"{folder}/{program.stem}.csv")
        counts = [0, 0, 0]
        for state in states:
            line = state["line"]
            self.assertEqual(comparison.off_explain(state), [], line)
            counts[0] += "start" in state
            if "explain" not in state:
                continue
            if "curve" not in state.get("refused", "") or "G64" in state.get("refused", ""):
                self.assertEqual(comparison.off_linuxcnc(state["explain"], linuxcnc[line], inches=False), [], line)
                counts[1] += 1
                off_mm = comparison.off_ticks(state, ticks)
                if off_mm is not None:
                    self.assertLess(off_mm, 1e-3, line)
                    counts[2] += 1
        return counts

    def test_every_line_of_the_shipped_programs(self):
        compared = [0, 0, 0]
        with tempfile.TemporaryDirectory() as folder:
            for program in PROGRAMS:
                with self.subTest(program=program.name):
                    compared = [sum(pair) for pair in zip(compared, self.judge(program, folder))]
        print(f"lines whose start is explain's {compared[0]}, LinuxCNC's {compared[1]}, the ticks' {compared[2]}", file=sys.stderr)
        self.assertGreater(min(compared), 800)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
