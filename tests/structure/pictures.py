#!/usr/bin/env python3
"""The pictures of docs/math.md are what their script draws, all of them and no others.

    pictures.py ROOT        exit status 1 and one line a finding
"""
import pathlib
import subprocess
import sys
import tempfile

FOLDER = "docs/pictures"
SCRIPT = "scripts/draw_math_pictures.py"


def findings(root):
    committed = {path.name: path.read_bytes() for path in (pathlib.Path(root) / FOLDER).iterdir()}
    with tempfile.TemporaryDirectory(prefix="pictures ") as fresh:
        subprocess.run([sys.executable, pathlib.Path(root) / SCRIPT, fresh], check=True)
        drawn = {path.name: path.read_bytes() for path in pathlib.Path(fresh).iterdir()}
    for name in sorted(committed.keys() | drawn.keys()):
        if name not in drawn:
            yield f"{FOLDER}/{name}:1: error: {SCRIPT} does not draw it"
        elif name not in committed:
            yield f"{FOLDER}/{name}:1: error: {SCRIPT} draws it, but it is not there"
        elif committed[name] != drawn[name]:
            yield f"{FOLDER}/{name}:1: error: it is not what {SCRIPT} draws"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "the pictures are what their script draws")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
