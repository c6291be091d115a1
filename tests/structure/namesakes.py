#!/usr/bin/env python3
"""A type that a header offers has its name for itself: no other type of a namespace in the tree has the same.

    namesakes.py ROOT       exit status 1 and one line a finding

Types within a class are named with it, and those of a .cpp file may share their names among each other.
"""
import collections
import pathlib
import re
import sys

FOLDERS = ("include", "parser", "diagnostics", "curves", "profiles", "smoothing", "lookahead", "interp", "machine", "kernel", "control",
           "programs")
# What stands within a class is indented.
TYPE = re.compile(r"^(?:template <[^\n]*>\s+)?(?:struct|class|union|enum class|enum) (?:KERF_API )?(\w+)(?: final)?(?:\s*:\s[^;{]*)?\s*\{",
                  re.MULTILINE)
# Another name of the same type is no namesake: using Setpoint = kerf::Setpoint;
ALIAS = re.compile(r"^using (\w+) = (?!(?:\w*::)*\1;)", re.MULTILINE)
# Pairs that nobody mixes up, each with its reason.
MEANT = {
    "Wide": "long double in both",
}


def findings(root):
    root = pathlib.Path(root)
    places = collections.defaultdict(list)
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            text = path.read_text(encoding="utf-8")
            for match in [*TYPE.finditer(text), *ALIAS.finditer(text)]:
                places[match.group(1)].append((path.relative_to(root), text.count("\n", 0, match.start()) + 1))
    for name in sorted(places.keys() - MEANT.keys()):
        headers = [place for place in places[name] if place[0].suffix == ".hpp"]
        if headers and len(places[name]) > 1:
            first = headers[0]
            for path, line in places[name]:
                if (path, line) != first:
                    yield f"{path}:{line}: error: {name} is the name of another type, in {first[0]}"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "every type has a name of its own")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
