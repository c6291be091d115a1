#!/usr/bin/env python3
"""Row 58 of the faults: another level of optimisation gives the same ticks within 1e-9 mm.

    other_builds_test.py KERF             against ticks_of_a_debug_build.csv beside this file
    other_builds_test.py KERF --record    writes that file; KERF of a build with -O0
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
RECORDED = pathlib.Path(__file__).resolve().with_name("ticks_of_a_debug_build.csv")
PROGRAMS = ("butterfly", "polygon", "pocket")
PROFILES = ("time-optimal", "s-curve", "sine-series")
EVERY = 2000  # ticks, and the last
TOLERANCE_MM = 1e-9


def ticks(kerf, program, profile):
    """(tick, x, y, z) of every 2000th tick and of the last."""
    with tempfile.TemporaryDirectory() as folder:
        trace = pathlib.Path(folder) / "trace.csv"
        subprocess.run([kerf, "dry-run", ROOT / "programs" / f"{program}.ngc", "--profile", profile, "--trace", trace],
                       check=True, stdout=subprocess.DEVNULL)
        with trace.open(encoding="ascii", newline="") as file:
            rows = list(csv.DictReader(file))
    chosen = [*range(0, len(rows) - 1, EVERY), len(rows) - 1]
    return [(tick, *(rows[tick][axis] for axis in ("x_mm", "y_mm", "z_mm"))) for tick in chosen]


def main():
    kerf = sys.argv[1]
    found = [(program, profile, *map(str, row)) for program in PROGRAMS for profile in PROFILES for row in ticks(kerf, program, profile)]
    if "--record" in sys.argv:
        with RECORDED.open("w", encoding="ascii", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(found)
        return
    with RECORDED.open(encoding="ascii", newline="") as file:
        recorded = [tuple(row) for row in csv.reader(file)]
    assert [row[:3] for row in found] == [row[:3] for row in recorded], "the programs last for other numbers of ticks"
    apart, place = max((abs(float(a) - float(b)), row[:3]) for row, other in zip(found, recorded) for a, b in zip(row[3:], other[3:]))
    assert apart <= TOLERANCE_MM, f"{apart} mm apart at {place}"
    print(f"{len(found)} ticks, at most {apart} mm apart")


if __name__ == "__main__":
    main()
