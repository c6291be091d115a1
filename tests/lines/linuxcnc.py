"""What is in force before each line of a program, as LinuxCNC's rs274 has it.

Before each line goes a DEBUG comment that names the line and tells what LinuxCNC can tell of itself; offsets and path modes come from
the calls that rs274 lists. How its listing is to be read stands in tests/conformance/make_golden. RS274 names the program.
"""
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

CONFORMANCE = pathlib.Path(__file__).resolve().parent.parent / "conformance" / "make_golden"
RS274 = os.environ.get("RS274") or shutil.which("rs274")
# A line of rs274 holds 255 characters.
TOLD = ("x #5420 y #5421 z #5422 motion #<_motion_mode> mm #<_metric> plane #<_plane> s #<_rpm> absolute #<_absolute>",
        "inverse #<_inverse_time> minute #<_units_per_minute> centre #<_ijk_absolute_mode> tool #<_current_tool> next #<_selected_tool>",
        "system #<_coord_system> comp #<_ccomp> on #<_spindle_on> cw #<_spindle_cw> mist #<_mist> flood #<_flood>",
        "css #<_spindle_css_mode> speed #<_speed_override> feed #<_feed_override> adaptive #<_adaptive_feed> hold #<_feed_hold>")
TOOLS_MM = {1: (10, 12.5), 2: (6, 0), 3: (20, -3), **{number: (0, 0) for number in range(4, 61)}}  # number: diameter, length; of table.toml
AXES = "xyz"


def listing():
    loader = importlib.machinery.SourceFileLoader("make_golden", str(CONFORMANCE))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("make_golden", loader))
    loader.exec_module(module)
    return module.Listing(events=False, turns=False), module.LINE


def told_before(lines):
    """The program with a comment before each line; its first % stays first."""
    out = []
    for number, line in enumerate(lines, 1):
        if not (number == 1 and line.strip().startswith("%")):
            out += [f"(DEBUG,@{number} {part})" for part in TOLD]
        out.append(line)
    return "\n".join(out) + "\n"


def run(program, text):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for beside in program.parent.glob("*.ngc"):
            shutil.copy(beside, folder)
        (folder / "told").write_text(text, encoding="latin-1")
        (folder / "e.var").write_text("")
        (folder / "t.tbl").write_text("".join(f"T{n} P{n} D{d / 25.4:.12g} Z{z / 25.4:.12g}\n" for n, (d, z) in TOOLS_MM.items()))
        (folder / "o.ini").write_text("[EMC]\nMACHINE=lines\n[TRAJ]\nLINEAR_UNITS=mm\n[RS274NGC]\nPARAMETER_FILE=e.var\n")
        done = subprocess.run([RS274, "-v", "e.var", "-t", "t.tbl", "-i", "o.ini", "-g", "told"], cwd=folder, timeout=600,
                              env={**os.environ, "HOME": name, "TMPDIR": name}, capture_output=True)
    said = [line for line in done.stderr.decode("latin-1").splitlines() if line.strip() and not line.startswith("executing")]
    return done.stdout.decode("latin-1"), "; ".join(said)


def codes_of(told, path_mode):
    motion = "G80" if told["motion"] < 0 else f"G{told['motion'] / 10:g}"  # G5.3 leaves none
    codes = {motion, f"G{told['plane'] / 10:g}", f"G{told['comp'] / 10:g}", f"G{told['system'] / 10:g}", path_mode}
    for key, yes, no in (("mm", "G21", "G20"), ("absolute", "G90", "G91"), ("centre", "G90.1", "G91.1"),
                         ("css", "G96", "G97"), ("mist", "M7", ""), ("flood", "M8", ""), ("adaptive", "M52", ""),
                         ("feed", "", "M50 P0"), ("speed", "", "M51 P0"), ("hold", "", "M53 P0")):
        codes.add(yes if told[key] else no)
    codes.add("G93" if told["inverse"] else "G94" if told["minute"] else "G95")
    codes.add("M5" if not told["on"] else "M3" if told["cw"] else "M4")
    if not told["mist"] and not told["flood"]:
        codes.add("M9")
    return sorted(codes - {""})


def state_of(told, place, path_mode):
    """In mm, mm/min and degrees, rounded to what rs274 prints."""
    unit = 1.0 if told["mm"] else 25.4
    program = [told[axis] * unit for axis in AXES]
    of_program = [told[axis] for axis in AXES]
    state = {"program": program, "machine": place.machine(of_program), "work": list(place.work), "local": list(place.shift),
             "tool_offset": list(place.tool)}
    state = {key: [round(value, 6) + 0.0 for value in values] for key, values in state.items()}
    state["turn"] = round(place.rotation * 57.29577951308232, 6)
    # #<_feed> is the number that was written last, and of another unit after G20 and G21: what counts is the call.
    state["feed"] = round(place.feed, 6) if told["minute"] else None
    state.update(speed=told["s"], tool=int(told["tool"]), next=int(told["next"]), codes=codes_of(told, path_mode))
    return state


def as_lines(lines):
    """The blocks of G6.2 curves, which rs274 of LinuxCNC 2.9 does not know, as lines from control point to control point."""
    out, in_curve = [], False
    for line in lines:
        begins = re.match(r"G6\.2\b", line) is not None
        in_curve = begins or (in_curve and re.search(r"\bK[-.\d]", line) is not None)
        if in_curve:
            line = "G1 " * begins + " ".join(re.findall(r"\b[XYZF][-.\d]+", line))
        out.append(line)
    return out


def states_of(program, is_fanuc=False):
    """Line: what is in force before it runs for the first time. And what rs274 refuses, if anything. In place of a program number of Fanuc's
    dialect it gets G98, in which a Fanuc control begins."""
    lines = program.read_bytes().decode("latin-1").splitlines()
    if is_fanuc:
        lines = [re.sub(r"^\s*[Oo:]\d+[^(]*", "G98 ", line) for line in lines]
    text, refusal = run(program, told_before(as_lines(lines)))
    place, call = listing()
    states, told, path_mode = {}, {}, "G64"  # in which LinuxCNC begins
    for line in text.splitlines():
        match = call.match(line)
        if not match:
            continue
        name, words = match.groups()
        if name == "SET_MOTION_CONTROL_MODE":
            path_mode = {"PATH": "G61", "STOP": "G61.1"}.get(words.split(",")[0].rsplit("_", 1)[1], "G64")
        elif name != "MESSAGE" or not words.startswith('"@'):
            place.take(name, words)
            continue
        else:
            number, *words = words.strip('"').lstrip("@").split()
            told.setdefault(int(number), {}).update({key: float(value) for key, value in zip(words[::2], words[1::2])})
            if "hold" in words:  # the last part
                one = told.pop(int(number))
                states.setdefault(int(number), state_of(one, place, path_mode))
    return states, refusal
