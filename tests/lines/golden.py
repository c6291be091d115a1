"""LinuxCNC's states of the shipped programs, kept in linuxcnc/: line by line what is another than before the line above."""
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent / "linuxcnc"
TRIPLES = ("program", "machine", "work", "local", "tool_offset")
HEAD = "# What is in force before each line, as far as it changes: rs274 -g, LinuxCNC 2.9.0~pre1; written by tests/lines/make_golden"


def flat(state):
    """As words. Of the machine's place only where it is another than the program's."""
    words = {f"{key}.{axis}": f"{value:g}" if value == round(value) else f"{value:.6f}".rstrip("0")
             for key in TRIPLES if key != "machine" or state["machine"] != state["program"] for axis, value in zip("xyz", state[key])}
    words.update({key: repr(state[key]) for key in ("turn", "feed", "speed", "tool", "next")})
    words["codes"] = ",".join(code.replace(" ", "_") for code in state["codes"])
    return words


def text_of(states):
    lines, before = [HEAD], {}
    for number in sorted(states):
        words = flat(states[number])
        changes = [f"{key}={value}" for key, value in words.items() if before.get(key) != value]
        lines.append(" ".join([str(number), *changes]))
        before = words
    return "\n".join(lines) + "\n"


def states_of(text):
    states, words = {}, {}
    for line in text.splitlines():
        if line.startswith("#"):
            continue
        number, *changes = line.split(" ")
        words = {**words, **dict(change.split("=", 1) for change in changes)}
        state = {key: [float(words[f"{key}.{axis}"]) for axis in "xyz"] for key in TRIPLES if f"{key}.x" in words}
        state.setdefault("machine", state["program"])
        state.update({key: None if words[key] == "None" else float(words[key]) for key in ("turn", "feed", "speed", "tool", "next")})
        state["codes"] = [code.replace("_", " ") for code in words["codes"].split(",")]
        states[int(number)] = state
    return states
