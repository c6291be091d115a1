#!/usr/bin/env python3
"""Every error page is in its topic's list, every list in the catalogue, and every page has a place in the code that uses it.

    error_pages.py ROOT     exit status 1 and one line a finding, in the form file:line: error: ...
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from sources import cpp_files  # noqa: E402

PAGE = re.compile(r"\binline constexpr ErrorPage (k\w+)")
LIST = re.compile(r"\binline constexpr std::array (k\w+)\s*\{([^}]*)\}")
NAME = re.compile(r"\bk\w+")


def findings(root):
    root = pathlib.Path(root)
    folder = root / "diagnostics" / "errors"
    catalogue = set(NAME.findall((folder / "catalogue.cpp").read_text(encoding="utf-8")))
    used = set()
    for path in cpp_files(root):
        if path.parent != folder and path.relative_to(root).parts[0] != "tests":
            used.update(NAME.findall(path.read_text(encoding="utf-8")))
    for path in sorted(folder.glob("*.hpp")):
        text = path.read_text(encoding="utf-8")
        lists = LIST.findall(text)
        listed = {name for _, names in lists for name in NAME.findall(names)}
        for page in PAGE.finditer(text):
            name, line = page.group(1), text.count("\n", 0, page.start()) + 1
            if name not in listed:
                yield f"{path.relative_to(root)}:{line}: error: {name} is in no list of this file"
            if name not in used:
                yield f"{path.relative_to(root)}:{line}: error: nothing gives {name}"
        for name, _ in lists:
            if name not in catalogue:
                yield f"{path.relative_to(root)}:1: error: {name} is not in the catalogue"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "every error page is listed and used")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
