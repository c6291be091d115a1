#!/usr/bin/env python3
"""What the playground is built of takes from std::ranges what web/kernel/libcxx14.hpp has: Debian's libc++ for it has none.

    browser.py ROOT         exit status 1 and one line a finding

The sources are those of the folders that web/kernel/CMakeLists.txt names. An assertion is not built there.
"""
import pathlib
import re
import sys

BUILD = "web/kernel/CMakeLists.txt"
OFFER = "web/kernel/libcxx14.hpp"
FOLDERS = re.compile(r"foreach\(folder ([^)]*)\)")
OFFERED = re.compile(r"^(?:constexpr |inline )*\w+ (\w+)\((?!\))", re.MULTILINE)
TAKEN = re.compile(r"std::ranges::(\w+)")


def findings(root):
    root = pathlib.Path(root)
    folders = FOLDERS.search((root / BUILD).read_text(encoding="utf-8"))
    offered = set(OFFERED.findall((root / OFFER).read_text(encoding="utf-8")))
    for folder in folders.group(1).split() if folders else []:
        for path in sorted((root / folder).rglob("*.[ch]pp")):
            for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
                for name in TAKEN.findall(line):
                    if name not in offered and "assert(" not in line:
                        yield f"{path.relative_to(root)}:{number}: error: std::ranges::{name} is not in {OFFER}"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "the browser's library has what the playground takes")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
