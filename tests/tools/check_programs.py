#!/usr/bin/env python3
"""Runs kerf on a shipped NURBS program and judges the ticks of its curve from outside.

    check_programs.py --kerf KERF --machine MACHINE.toml [--profile NAME ...] PROGRAM.ngc CURVE.json

For each profile: `kerf dry-run PROGRAM --machine ... --profile ... --trace ...`; the way to the curve is cut away, up to the tick
where the tool rests on the curve's first point; then check_ticks.py (--rest, --curve, --chord, --tol 0.005) and tick_laws.py judge.
Exit status 0 when all pass, 1 otherwise. Python standard library only.
"""
import argparse
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import tick_laws  # noqa: E402
from nurbs import Nurbs  # noqa: E402

PROFILES = ("s-curve", "sine", "quintic", "sine-series", "sigmoid", "time-optimal")
HEADER = "t_s,line,s_mm,v_mm_s,a_mm_s2,j_mm_s3,x_mm,y_mm,z_mm,actual_x_mm,actual_y_mm,actual_z_mm,u,chord_error_mm"
TOLERANCE = "0.005"


class Unusable(Exception):
    """The trace is not what can be judged."""


def curve_line(program):
    """The line of the block that starts the curve."""
    for number, line in enumerate(pathlib.Path(program).read_text(encoding="ascii").splitlines(), 1):
        if re.match(r"G0*6\.2\b", line):
            return number
    raise Unusable(f"{program}: no G6.2")


def cut_approach(trace, program, curve, cut):
    """Writes to `cut` the rows from the tick on where the tool rests on the curve's first point.

    That tick counts for the curve or, where it still carries the line of what was before, is the last before it.
    """
    with open(trace, newline="", encoding="ascii") as handle:
        header = handle.readline().rstrip("\r\n")
        if header != HEADER:
            raise Unusable(f"{trace}: header is {header}")
        rows = list(csv.reader(handle))
    start = curve_line(program)
    first = next((i for i, row in enumerate(rows) if int(row[1]) >= start), None)
    if not first:
        raise Unusable(f"{trace}: no tick of the curve, or none before it")
    point = [*curve["control_points"][0], 0.0][:3]
    gaps = {i: math.dist([float(c) for c in rows[i][6:9]], point) for i in (first, first - 1)}
    first = next((i for i, gap in gaps.items() if gap <= 1e-9), None)
    if first is None:
        raise Unusable(f"{trace}: no tick rests on the curve's first point; the nearest is {min(gaps.values()):.3g} mm away")
    with open(cut, "w", encoding="ascii") as handle:
        handle.write(header + "\n" + "".join(",".join(row) + "\n" for row in rows[first:]))


def judge(args, profile, folder):
    """What is wrong with one profile's ticks: a list of texts."""
    trace, cut = pathlib.Path(folder) / f"{profile}.csv", pathlib.Path(folder) / f"{profile}-curve.csv"
    run = subprocess.run([args.kerf, "dry-run", args.program, "--machine", args.machine, "--profile", profile, "--trace", trace],
                         capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return [f"kerf ended with {run.returncode}: {(run.stderr or run.stdout).strip()[-500:]}"]
    curve = json.loads(pathlib.Path(args.curve).read_text(encoding="utf-8"))
    try:
        cut_approach(trace, args.program, curve, cut)
    except Unusable as problem:
        return [str(problem)]
    limits = tick_laws.path_limits(args.machine)
    options = []
    for name, value in zip(("--ts", "--v", "--a", "--j", "--chord"), limits):
        if math.isfinite(value):
            options += [name, repr(value)]
    judged = subprocess.run([sys.executable, HERE / "check_ticks.py", cut, *options, "--curve", args.curve, "--rest", "--tol", TOLERANCE],
                            capture_output=True, text=True, check=False)
    problems = [] if judged.returncode == 0 else ["check_ticks:\n" + (judged.stdout + judged.stderr).rstrip()]
    laws = tick_laws.broken_laws(tick_laws.read_trace(cut), Nurbs(curve), limits)
    return problems + [f"{law}: {text}" for law, text in laws]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("curve")
    parser.add_argument("--kerf", required=True)
    parser.add_argument("--machine", required=True)
    parser.add_argument("--profile", action="append", help="default: every profile but trapezoid")
    args = parser.parse_args()
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for profile in args.profile or PROFILES:
            problems = judge(args, profile, folder)
            failed += bool(problems)
            print(f"{pathlib.Path(args.program).name} {profile}: " + ("\n  ".join(problems) or "good"), flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
