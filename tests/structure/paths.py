#!/usr/bin/env python3
"""No file of the project names a place that only one machine has.

    paths.py ROOT           exit status 1 and one line a finding
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from sources import project_files  # noqa: E402

# Not after a letter, dot or slash: those are parts of addresses and relative paths.
PLACE = re.compile(rb"(?<![\w./~$}-])/(?:work|home|root|Users|mnt|media)/[\w.]+|[A-Z]:\\Users\\")


def findings(root):
    root = pathlib.Path(root)
    for path in project_files(root):
        for number, line in enumerate(path.read_bytes().split(b"\n"), 1):
            place = PLACE.search(line)
            if place:
                yield f"{path.relative_to(root)}:{number}: error: names {place.group().decode()}"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "no file names a place of one machine")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
