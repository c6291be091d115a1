#!/usr/bin/env python3
"""What is installed: headers that need nothing of Kerf's inside, and a library that shows nothing of it.

    front_door_test.py PREFIX COMPILER LIBRARY [FLAG...]        the flags that it was compiled with
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PREFIX, COMPILER, LIBRARY = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
FLAGS = sys.argv[4:]
MOST_LINES = 40_000


def output(*command, text=None):
    return subprocess.run(command, input=text, check=True, capture_output=True, text=True).stdout


class FrontDoor(unittest.TestCase):
    def headers(self):
        return sorted((PREFIX / "include").rglob("*.hpp"))

    def test_each_header_compiles_by_itself(self):
        self.assertGreater(len(self.headers()), 5)
        for header in self.headers():
            with self.subTest(header=header.name):
                include = f"#include <{header.relative_to(PREFIX / 'include')}>\n"
                output(COMPILER, "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-I", PREFIX / "include", "-x", "c++", "-", text=include)

    def test_all_of_it_is_small_for_a_compiler(self):
        lines = output(COMPILER, "-std=c++20", "-E", "-P", "-I", PREFIX / "include", "-x", "c++", "-", text="#include <kerf/kerf.hpp>\n")
        self.assertLessEqual(lines.count("\n"), MOST_LINES)

    def test_one_header_includes_all_others(self):
        front = (PREFIX / "include/kerf/kerf.hpp").read_text()
        named = set(re.findall(r"#include <kerf/([a-z_]+\.hpp)>", front))
        self.assertEqual(named | {"kerf.hpp", "api.hpp"}, {header.name for header in self.headers()})

    def test_pkg_config_finds_it(self):
        folder = next((PREFIX).rglob("kerf.pc")).parent
        flags = output("pkg-config", f"--with-path={folder}", "--cflags", "--libs", "kerf").split()
        include = next(pathlib.Path(flag[2:]) for flag in flags if flag.startswith("-I"))
        library = next(pathlib.Path(flag[2:]) for flag in flags if flag.startswith("-L"))
        self.assertTrue((include / "kerf/kerf.hpp").is_file())
        self.assertTrue(list(library.glob("libkerf.*")))
        self.assertIn("-lkerf", flags)

    def test_licence_and_machine_files_come_with_it(self):
        self.assertTrue(list(PREFIX.rglob("share/doc/*/LICENSE")))
        self.assertTrue((PREFIX / "share/kerf/machines/table.toml").is_file())

    def test_a_shared_library_of_it_shows_the_front_door_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            shared = LIBRARY
            if LIBRARY.suffix == ".a":
                shared = pathlib.Path(folder) / "libkerf.so"
                output(COMPILER, *FLAGS, "-shared", "-o", shared, "-Wl,--whole-archive", LIBRARY, "-Wl,--no-whole-archive", "-Wl,-z,defs", "-lm")
            shown = output("nm", "-DC", "--defined-only", shared).splitlines()
        own = [line.split(maxsplit=2)[2] for line in shown if "kerf::" in line]
        self.assertTrue(any(name.startswith("kerf::v0::Kernel::tick(") for name in own))
        self.assertEqual([name for name in own if re.search(r"kerf::(?!v0::)", name)], [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
