#!/usr/bin/env python3
"""What every tick of one NURBS must satisfy, judged more sharply than limits on finite differences can.

    tick_laws.py TRACE.csv --curve CURVE.json --machine MACHINE.toml

The trace is one curve from rest to rest, first tick at rest on its first point. Checked:
  clock      row i is at i periods after the first
  on_curve   a tick lies within 1e-9 mm of the curve (plus what ten printed decimals lose), and never after the one before
  length     s_mm grows by the arc length between ticks: feedrate fluctuation below 1e-6 of the plan
  plan       v_mm_s, a_mm_s2 and j_mm_s3 are the derivatives of s_mm as far as a bounded jerk allows
  limits     the planned v, a and j keep the limits along the path without any tolerance
  chord      the curve between two ticks keeps to the chord tolerance
  ends       first and last tick at rest, on the curve's end points
Exit status 0, or 1 and one line a broken law. Python standard library only.
"""
import argparse
import csv
import math
import sys
import tomllib

from nurbs import Nurbs

COLUMNS = ("t_s", "s_mm", "v_mm_s", "a_mm_s2", "j_mm_s3", "x_mm", "y_mm", "z_mm")
PRINTED_MM = 1e-10  # positions and s_mm have ten decimals


def read_trace(path):
    with open(path, newline="", encoding="ascii") as handle:
        return [{name: float(row[name]) for name in COLUMNS} for row in csv.DictReader(handle)]


def path_limits(machine):
    """period, v, a, j, chord of a machine file; a key left out does not bind."""
    with open(machine, "rb") as handle:
        data = tomllib.load(handle)
    path = data.get("path", {})
    names = ("max_velocity_mm_s", "max_acceleration_mm_s2", "max_jerk_mm_s3", "chord_tolerance_mm")
    return [data.get("tick", {}).get("period_s", 0.001), *(float(path.get(name, math.inf)) for name in names)]


def sagitta(curve, low, high):
    """Largest distance between the curve and its chord over a step."""
    (a, _), (b, _) = curve.evaluate(low), curve.evaluate(high)
    along = [q - p for p, q in zip(a, b)]
    square, worst = sum(c * c for c in along), 0.0
    for k in (1, 2, 3, 4, 5):
        here, _ = curve.evaluate(low + (high - low) * k / 6)
        share = sum((p - q) * c for p, q, c in zip(here, a, along)) / square if square else 0.0
        worst = max(worst, math.dist(here, [p + share * c for p, c in zip(a, along)]))
    return worst


def broken_laws(rows, curve, limits):
    """(law, text) of what does not hold, the worst place of each law only."""
    period, v_max, a_max, j_max, chord = limits
    worst = {}

    def judge(law, excess, text):
        if not excess <= 1.0 and excess > worst.get(law, (1.0,))[0]:
            worst[law] = (excess, text)
        elif math.isnan(excess):
            worst[law] = (math.inf, text)

    u, step = curve.first, 0.0
    for i, row in enumerate(rows):
        at = f"tick {i}"
        judge("clock", abs(row["t_s"] - rows[0]["t_s"] - i * period) / 1e-9, f"{at}: at {row['t_s']} s")
        position = (row["x_mm"], row["y_mm"], row["z_mm"])
        before = u
        u, gap = curve.nearest(position, u + step, u)
        step = u - before
        judge("on_curve", gap / (1e-9 + PRINTED_MM), f"{at}: {gap:.3g} mm from the curve")
        for name, value, limit in (("v", row["v_mm_s"], v_max), ("a", row["a_mm_s2"], a_max), ("j", row["j_mm_s3"], j_max)):
            judge("limits", abs(value) / limit / (1 + 1e-9), f"{at}: {name} = {value}")
        judge("limits", 1.0 if row["v_mm_s"] >= -1e-9 else 2.0, f"{at}: v = {row['v_mm_s']} runs back")
        if i == 0:
            continue
        last, length = rows[i - 1], curve.length(before, u)
        travelled = row["s_mm"] - last["s_mm"]
        # Rounding of both positions and both lengths to print bounds how well the shortest steps can be judged.
        judge("length", abs(travelled - length) / (1e-6 * length + 8 * PRINTED_MM),
              f"{at}: s grows by {travelled:.12g} mm where the curve has {length:.12g}")
        judge("chord", sagitta(curve, before, u) / (chord * (1 + 1e-6) + PRINTED_MM), f"{at}: chord error beyond {chord} mm")
        planned = period * (row["v_mm_s"] + last["v_mm_s"]) / 2
        judge("plan", abs(travelled - planned) / (j_max * period ** 3 / 4 + 2 * PRINTED_MM),
              f"{at}: s grows by {travelled:.12g} mm where v says {planned:.12g}")
        gained = row["v_mm_s"] - last["v_mm_s"]
        judge("plan", abs(gained - period * (row["a_mm_s2"] + last["a_mm_s2"]) / 2) / (j_max * period ** 2 / 2 + 1e-9),
              f"{at}: v grows by {gained} mm/s against its a")
        judge("plan", abs(row["a_mm_s2"] - last["a_mm_s2"]) / (j_max * period * (1 + 1e-9) + 1e-6), f"{at}: a jumps")
    for name, row, target in (("first", rows[0], curve.first), ("last", rows[-1], curve.last)):
        judge("ends", abs(row["v_mm_s"]) / 1e-6, f"the {name} tick is not at rest: {row['v_mm_s']} mm/s")
        gap = math.dist((row["x_mm"], row["y_mm"], row["z_mm"]), curve.evaluate(target)[0])
        judge("ends", gap / (1e-9 + PRINTED_MM), f"the {name} tick is {gap:.3g} mm from the curve's end")
    return [(law, text) for law, (_, text) in sorted(worst.items())]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trace")
    parser.add_argument("--curve", required=True)
    parser.add_argument("--machine", required=True)
    args = parser.parse_args()
    broken = broken_laws(read_trace(args.trace), Nurbs.load(args.curve), path_limits(args.machine))
    print("\n".join(f"{law}: {text}" for law, text in broken) or "all laws hold")
    sys.exit(1 if broken else 0)


if __name__ == "__main__":
    main()
