"""A start at each line of a program against `explain`, LinuxCNC and the ticks of a dry run."""
import csv
import json
import math
import subprocess

AXES = "xyz"
OF_EXPLAIN = ("begin_s", "duration_s", "line")
OF_START = ("round", "calls", "line")
# Of what rs274 tells, offsets have four decimals, in inches where the program is.
OFFSET_MM = 0.6e-4
IN_INCHES = 25.4


def kerf_states(line_states, program, machine, dialect="rs274", step=1):
    """A list of what line_states writes."""
    done = subprocess.run([line_states, program, machine, dialect, str(step)], capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def off_explain(state):
    """Names of what the start shows and explain does not say so."""
    if not state["is_asked"]:
        return []
    if ("start" in state) != ("explain" in state):
        return ["whether it runs"]
    start, block = state.get("start", {}), state.get("explain", {})
    keys = (set(start) - set(OF_START)) | (set(block) - set(OF_EXPLAIN))
    return sorted(key for key in keys if start.get(key) != block.get(key))


def numbers_of(start):
    return {"program": [start["program_position_mm"][axis] for axis in AXES], "machine": [start["position_mm"][axis] for axis in AXES],
            "work": [start["work_offset_mm"][axis] for axis in AXES], "local": [start["local_offset_mm"][axis] for axis in AXES],
            "tool_offset": [start["tool_offset_mm"][axis] for axis in AXES], "turn": [start["work_rotation_deg"]],
            "feed": [None if start["feedrate_mm_s"] is None else start["feedrate_mm_s"] * 60], "speed": [start["spindle_speed"]],
            "tool": [start["tool"]], "next": [start["selected_tool"]]}


def codes_of(start):
    """rs274 does not tell G43, G49, G98 and G99, nor G41.1 from G41, and gets the curves of G6.2 as lines."""
    as_told = {"G6.2": "G1", "G41.1": "G41", "G42.1": "G42"}
    return {as_told.get(code, code) for code in start["codes"]} - {"G43", "G49", "G98", "G99"}


def off_linuxcnc(start, wanted, inches):
    """Texts: what, Kerf, LinuxCNC."""
    tolerance = OFFSET_MM * (IN_INCHES if inches else 1.0)
    off = []
    numbers = numbers_of(start)
    if "G40" not in start["codes"]:  # LinuxCNC says where the tool is, Kerf where the program is
        del numbers["program"], numbers["machine"]
    for key, values in numbers.items():
        expected = wanted[key] if isinstance(wanted[key], list) else [wanted[key]]
        # Where the program says no feed yet LinuxCNC has 0.
        for value, right in zip(values, expected):
            if right is None or (value is None and right == 0):
                continue
            if value is None or abs(value - right) > (4 * tolerance if key == "machine" else tolerance) * max(1.0, 1e-6 * abs(right)):
                off.append(f"{key} {value} {right}")
    codes, right = codes_of(start), set(wanted["codes"])
    if codes != right:
        off.append(f"codes {sorted(codes - right)} {sorted(right - codes)}")
    return off


def cycle_time_s(kerf, program, machine, dialect):
    done = subprocess.run([kerf, "check", program, "--machine", machine, "--dialect", dialect, "--json"], check=True, capture_output=True)
    return json.loads(done.stdout)["cycle_time_s"]


def ticks_of(kerf, program, machine, dialect, trace):
    """Places of a dry run, tick by tick, and the first tick of each line."""
    subprocess.run([kerf, "dry-run", program, "--machine", machine, "--dialect", dialect, "--trace", trace, "-q"], check=True, capture_output=True)
    places, first = [], {}
    with open(trace, encoding="ascii") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            first.setdefault(int(row["line"]), len(places))
            places.append([float(row[f"{axis}_mm"]) for axis in AXES])
    return {"places": places, "first": first}


def off_ticks(state, ticks):
    """How far, beyond what G64 rounds, the tool passes by the place of the line as its motion begins. None: the line has no motion,
    runs more than once (its first tick may be of a later round), or the tool is beside the programmed path."""
    start = state["explain"]
    at = ticks["first"].get(state["line"])
    if at is None or state["runs"] > 1 or "G40" not in start["codes"] or "compensation" in state.get("refused", ""):
        return None
    place = [start["position_mm"][axis] for axis in AXES]
    ends = [ticks["places"][max(0, at - 1)], ticks["places"][at]]
    return distance(place, *ends) - start["corner_tolerance_mm"] - start["merge_tolerance_mm"]


def distance(place, a, b):
    way = [q - p for p, q in zip(a, b)]
    length2 = sum(w * w for w in way)
    share = max(0.0, min(1.0, sum((x - p) * w for x, p, w in zip(place, a, way)) / length2)) if length2 > 0 else 0.0
    return math.dist(place, [p + share * w for p, w in zip(a, way)])
