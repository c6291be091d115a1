#!/usr/bin/env python3
"""All sources are as clang-format 14 writes them (other versions write some lines otherwise).

    format.py ROOT          exit status 1 and the differing places; 77 where clang-format 14 is not at hand
"""
import re
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True
from sources import cpp_files  # noqa: E402

VERSION = "14"


def formatter():
    for name in ("clang-format-" + VERSION, "clang-format"):
        program = shutil.which(name)
        if program:
            said = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
            if re.search(rf"version {VERSION}\.", said):
                return program
    return None


def main():
    program = formatter()
    if program is None:
        print(f"skipped: no clang-format {VERSION} here (Debian 12: apt-get install clang-format)")
        sys.exit(77)
    files = cpp_files(sys.argv[1])
    result = subprocess.run([program, "--dry-run", "--Werror", "--style=file", *files], capture_output=True, text=True, check=False)
    sys.stdout.write(result.stderr or f"{len(files)} files are formatted\n")
    sys.exit(1 if result.returncode else 0)


if __name__ == "__main__":
    main()
