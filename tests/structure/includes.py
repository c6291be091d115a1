#!/usr/bin/env python3
"""Data flows one way, and includes follow it.

    includes.py ROOT        exit status 1 and one line a violation, in the form file:line: error: ...
"""
import pathlib
import posixpath
import re
import sys

sys.dont_write_bytecode = True
from sources import cpp_files  # noqa: E402

# Folder: the folders that it may include besides itself.
MAY_INCLUDE = {
    "profiles": set(),
    "curves": set(),
    "interp": {"curves", "profiles"},
    "machine": {"interp", "curves"},
    "diagnostics": set(),
    "parser": {"diagnostics"},
    "smoothing": {"diagnostics", "parser", "curves"},
    "lookahead": {"diagnostics", "parser", "smoothing", "curves", "profiles", "interp"},
    "kernel": {"diagnostics", "parser", "smoothing", "lookahead", "curves", "profiles", "interp", "machine"},
    "control": {"interp"},
}
LIBRARY = set(MAY_INCLUDE)

# What a unit of the interpreter may include: the block and the modal state, and neither the interpreter nor another unit.
PARSER_UNIT = {"parser/text", "parser/dialects", "parser/moves", "parser/block", "parser/modal"}
PARSER_UNITS = {"parser/offsets", "parser/spindle_io", "parser/cycles", "parser/compensation", "parser/curves",
                "parser/dialects/fanuc"}

# Subfolder: the folders of the same tree that it may include besides itself. Each names only folders above it in this
# table, so there is no circle. A tree that begins here is listed whole.
SUBFOLDERS = {
    "diagnostics/errors": set(),
    "diagnostics": {"diagnostics/errors"},
    "parser/text": set(),
    "parser/dialects": set(),
    "parser/moves": {"parser/text"},
    "parser/expressions": {"parser/text", "parser/dialects"},
    "parser/block": {"parser/text", "parser/expressions"},
    "parser/modal": {"parser/text", "parser/dialects", "parser/moves", "parser/block"},
    "parser/offsets": PARSER_UNIT | {"parser/expressions"},
    "parser/spindle_io": PARSER_UNIT,
    "parser/cycles": PARSER_UNIT,
    "parser/compensation": PARSER_UNIT,
    "parser/curves": PARSER_UNIT,
    "parser/dialects/fanuc": PARSER_UNIT | {"parser/offsets"},
    "parser/interpreter": PARSER_UNIT | PARSER_UNITS,
    "parser/flow": PARSER_UNIT | {"parser/expressions", "parser/interpreter"},
    "parser/reader": PARSER_UNIT | {"parser/expressions", "parser/offsets", "parser/dialects/fanuc", "parser/interpreter",
                                    "parser/flow"},
    "parser": {"parser/moves", "parser/flow", "parser/reader"},
    "lookahead/path": set(),
    "lookahead/emit": {"lookahead/path"},
    "lookahead/classical": {"lookahead/path", "lookahead/emit"},
    "lookahead/optimum/grid": {"lookahead/path"},
    "lookahead/optimum/solver": {"lookahead/path", "lookahead/optimum/grid"},
    "lookahead/optimum": {"lookahead/path", "lookahead/emit", "lookahead/classical", "lookahead/optimum/grid",
                          "lookahead/optimum/solver"},
    "lookahead": {"lookahead/path", "lookahead/emit", "lookahead/classical", "lookahead/optimum"},
    "programs/kerf": set(),
    "programs/kerf/io": {"programs/kerf"},
    "programs/kerf/report": {"programs/kerf", "programs/kerf/io"},
    "programs/kerf/plot": {"programs/kerf", "programs/kerf/io", "programs/kerf/report"},
    "programs/kerf/page": {"programs/kerf/io", "programs/kerf/report"},
    "programs/kerf/compare": {"programs/kerf", "programs/kerf/io", "programs/kerf/report"},
    "programs/kerf/control": {"programs/kerf", "programs/kerf/io", "programs/kerf/report"},
    "programs/kerf/driver": {"programs/kerf", "programs/kerf/io"},
    "programs/kerf/run": {"programs/kerf", "programs/kerf/driver", "programs/kerf/io", "programs/kerf/report", "programs/kerf/plot", "programs/kerf/page",
                         "programs/kerf/control"},
    "programs/kerf/cli": {"programs/kerf", "programs/kerf/io", "programs/kerf/report", "programs/kerf/page", "programs/kerf/run", "programs/kerf/compare"},
}
TICK_SIDE = {"profiles", "curves", "interp", "machine"}

# Foreign headers: which folders may include them. A folder outside the library (programs, tests, bench) may include any.
ONLY_IN = [
    (re.compile(r"boost/spirit"), {"parser"}, "Spirit"),
    (re.compile(r"(spdlog|fmt)/"), {"kernel"}, "spdlog"),
    (re.compile(r"toml\+\+/"), {"kernel"}, "toml++"),
    (re.compile(r"nlohmann/"), {"kernel"}, "JSON"),
    (re.compile(r"CLI/"), set(), "CLI11"),
    (re.compile(r"(iostream|fstream|mutex|shared_mutex|condition_variable|thread|future|filesystem)$"),
     LIBRARY - TICK_SIDE, "what logs, locks or opens files"),
]

# The front door (include/kerf): what a user includes. It stands on nothing but the standard library and tl/expected. These headers
# of it are values, which any folder may use; the others are the kernel's.
FRONT = "include/kerf"
VALUES = {"api", "axes", "diagnostic", "machine", "profile", "program_data", "program_inputs", "report", "setpoint", "simulation"}
FRONT_MAY_INCLUDE = re.compile(r"([a-z_0-9]+|tl/expected\.hpp|kerf/[a-z_]+\.hpp)$")

INCLUDE = re.compile(r"^\s*#\s*include(_next)?\b\s*(.*)$")
TARGET = re.compile(r'^(?:"([^"]+)"|<([^>]+)>)')


def tree_of(folder, subfolders):
    """The tree of the table that a folder stands in; None: none."""
    roots = {name for name in subfolders if not any(name.startswith(other + "/") for other in subfolders)}
    return next((root for root in roots if (folder + "/").startswith(root + "/")), None)


def subfolder_violation(folder, target, subfolders):
    """What is wrong with an include of a file in the folder `target`; None: nothing, or another tree's rule."""
    tree = tree_of(folder, subfolders)
    if tree is None or folder == target or tree_of(target, subfolders) != tree:
        return None
    if folder not in subfolders:
        return f"{folder} is not in the table of subfolders"
    return None if target in subfolders[folder] else f"{folder} must not include {target}"


def violations_in(text, path, root):
    """(line, message) of every include of one file that its folder may not have."""
    folder = path.relative_to(root).parts[0]
    for number, line in enumerate(text.splitlines(), 1):
        directive = INCLUDE.match(line)
        if not directive:
            continue
        target = TARGET.match(directive.group(2))
        if not target:
            yield number, "an include that names no file"
            continue
        header = target.group(1) or target.group(2)
        top = header.split("/")[0]
        if path.relative_to(root).parent.as_posix() == FRONT and not FRONT_MAY_INCLUDE.match(header):
            yield number, f"{FRONT} must not include <{header}>"
        if top == "kerf" and not (root / "include" / header).is_file():
            yield number, f"<{header}> is none of {FRONT}"
        if top == "kerf" and folder in LIBRARY - {"kernel", "control"} and pathlib.PurePath(header).stem not in VALUES:
            yield number, f"{folder} must not include the kernel (<{header}>)"
        sibling = folder not in LIBRARY and (path.parent / header).is_file()
        if target.group(1) and not sibling and not (root / header).is_file():
            yield number, f'"{header}" is no file of the project; the include path is its root'
        wrong = subfolder_violation(path.relative_to(root).parent.as_posix(), posixpath.dirname(header), SUBFOLDERS)
        if wrong and (root / header).is_file():
            yield number, f'{wrong} ("{header}")'
        if folder not in LIBRARY:
            continue
        if (root / header).is_file() and top != folder and top not in MAY_INCLUDE[folder]:
            yield number, f'{folder} must not include {top} ("{header}")'
        for pattern, folders, what in ONLY_IN:
            if pattern.match(header) and folder not in folders:
                yield number, f"{folder} must not include {what} (<{header}>)"


def violations(root):
    root = pathlib.Path(root)
    for path in cpp_files(root):
        relative = path.relative_to(root)
        # A project built against the installed library (tests/embedding) has another include path.
        if relative.parts[:2] == ("tests", "embedding"):
            continue
        for line, message in violations_in(path.read_text(encoding="utf-8"), path, root):
            yield f"{relative}:{line}: error: {message}"


def main():
    root = pathlib.Path(sys.argv[1])
    found = list(violations(root))
    print("\n".join(found) or f"{len(cpp_files(root))} files include what they may")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
