#!/usr/bin/env python3
"""Data flows one way, and includes follow it.

    includes.py ROOT        exit status 1 and one line a violation, in the form file:line: error: ...
"""
import pathlib
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
    "parser": set(),
    "smoothing": {"parser", "curves"},
    "lookahead": {"parser", "smoothing", "curves", "profiles", "interp"},
    "kernel": {"parser", "smoothing", "lookahead", "curves", "profiles", "interp", "machine"},
}
LIBRARY = set(MAY_INCLUDE)
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

INCLUDE = re.compile(r"^\s*#\s*include(_next)?\b\s*(.*)$")
TARGET = re.compile(r'^(?:"([^"]+)"|<([^>]+)>)')


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
        sibling = folder not in LIBRARY and (path.parent / header).is_file()
        if target.group(1) and not sibling and not (root / header).is_file():
            yield number, f'"{header}" is no file of the project; the include path is its root'
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
