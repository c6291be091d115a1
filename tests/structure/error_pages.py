#!/usr/bin/env python3
"""Every error page has a place in the code that uses it, and its lines are no longer than those of the code, which the formatter looks after.

    error_pages.py ROOT     exit status 1 and one line a finding, in the form file:line: error: ...
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from sources import cpp_files  # noqa: E402

PAGES = pathlib.PurePath("diagnostics", "errors", "pages.def")
PAGE = re.compile(r"ERROR_PAGE\((k\w+), ")
NAME = re.compile(r"\bk\w+")
COLUMNS = 100


def findings(root):
    root = pathlib.Path(root)
    used = set()
    for path in cpp_files(root):
        if path.relative_to(root).parts[0] != "tests":
            used.update(NAME.findall(path.read_text(encoding="utf-8")))
    for number, line in enumerate((root / PAGES).read_text(encoding="utf-8").splitlines(), 1):
        page = PAGE.match(line)
        if page and page.group(1) not in used:
            yield f"{PAGES}:{number}: error: nothing gives {page.group(1)}"
        if len(line) > COLUMNS:
            yield f"{PAGES}:{number}: error: longer than {COLUMNS} columns"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "every error page is used")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
