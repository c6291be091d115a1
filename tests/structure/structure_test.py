#!/usr/bin/env python3
"""The structure checks find what they are for, on made-up checkouts."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import error_pages  # noqa: E402
import includes  # noqa: E402
import paths  # noqa: E402


class Checkout(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="a checkout ")
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for header in ("parser/move.hpp", "curves/arc.hpp", "interp/setpoint.hpp", "kernel/kernel.hpp", "lookahead/path/block.hpp"):
            self.write(header, "#pragma once\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def found(self):
        return list(includes.violations(self.root))


class IncludeRule(Checkout):
    def test_accepts_the_direction_of_the_pipeline(self):
        self.write("lookahead/planner.cpp", '#include <vector>\n#include "lookahead/path/block.hpp"\n#include "parser/move.hpp"\n')
        self.write("interp/interpolator.cpp", '#include "curves/arc.hpp"\n')
        self.write("programs/main.cpp", '#include <spdlog/spdlog.h>\n#include "kernel/kernel.hpp"\n')
        self.assertEqual(self.found(), [])

    def test_names_file_and_line_of_a_tick_side_that_sees_the_parser(self):
        self.write("interp/interpolator.cpp", '#include <array>\n\n#include "parser/move.hpp"\n')
        self.assertEqual(self.found(), ['interp/interpolator.cpp:3: error: interp must not include parser ("parser/move.hpp")'])

    def test_refuses_every_way_back_up(self):
        for folder in ("profiles", "curves", "interp", "machine", "parser"):
            for header in ("lookahead/path/block.hpp", "kernel/kernel.hpp"):
                with self.subTest(folder=folder, header=header):
                    self.write(f"{folder}/wrong.cpp", f'#include "{header}"\n')
                    self.assertEqual(len(self.found()), 1)
                    (self.root / folder / "wrong.cpp").unlink()

    def test_refuses_the_same_in_angle_brackets_and_odd_spacing(self):
        self.write("machine/table.cpp", "  #  include<lookahead/path/block.hpp>\n")
        self.assertEqual(len(self.found()), 1)

    def test_keeps_spirit_and_spdlog_off_the_tick_side(self):
        for folder in ("profiles", "curves", "interp", "machine"):
            self.write(f"{folder}/wrong.hpp", "#include <boost/spirit/home/x3.hpp>\n#include <spdlog/spdlog.h>\n#include <mutex>\n")
        self.assertEqual(len(self.found()), 12)

    def test_lets_only_the_parser_have_spirit(self):
        self.write("parser/grammar.cpp", "#include <boost/spirit/home/x3.hpp>\n")
        self.assertEqual(self.found(), [])
        self.write("lookahead/wrong.cpp", "#include <boost/spirit/home/x3.hpp>\n")
        self.assertEqual(len(self.found()), 1)

    def test_keeps_the_front_door_on_its_own_feet(self):
        for name in ("setpoint", "kernel"):
            self.write(f"include/kerf/{name}.hpp", "#pragma once\n#include <array>\n#include <tl/expected.hpp>\n")
        self.write("interp/interpolator.cpp", "#include <kerf/setpoint.hpp>\n")
        self.write("kernel/kernel.cpp", "#include <kerf/kernel.hpp>\n")
        self.assertEqual(self.found(), [])
        self.write("include/kerf/machine.hpp", '#pragma once\n#include <Eigen/Core>\n#include "parser/move.hpp"\n')
        self.write("interp/wrong.cpp", "#include <kerf/kernel.hpp>\n#include <kerf/none.hpp>\n")
        self.assertEqual(len(self.found()), 5)

    def test_lets_a_subfolder_include_what_stands_below_it(self):
        self.write("lookahead/emit/emitter.cpp", '#include "lookahead/path/block.hpp"\n')
        self.assertEqual(self.found(), [])
        self.write("lookahead/emit/emitter.hpp", "#pragma once\n")
        self.write("lookahead/path/wrong.cpp", '#include "lookahead/emit/emitter.hpp"\n')
        self.assertEqual(self.found(), ['lookahead/path/wrong.cpp:1: error: lookahead/path must not include lookahead/emit ("lookahead/emit/emitter.hpp")'])

    def test_refuses_a_subfolder_that_the_table_does_not_know(self):
        self.write("lookahead/new/wrong.cpp", '#include "lookahead/path/block.hpp"\n')
        self.assertEqual(len(self.found()), 1)

    def test_has_no_circle_in_its_table(self):
        above = set()
        for folder, allowed in includes.SUBFOLDERS.items():
            self.assertLessEqual(allowed, above, folder)
            above.add(folder)

    def test_refuses_includes_that_do_not_start_at_the_root(self):
        self.write("curves/line.cpp", '#include "arc.hpp"\n')
        self.assertEqual(len(self.found()), 1)
        self.write("curves/line.cpp", '#include "../parser/move.hpp"\n')
        self.assertEqual(len(self.found()), 1)

    def test_lets_a_test_name_its_neighbour(self):
        self.write("tests/curves/reference.hpp", "#pragma once\n")
        self.write("tests/curves/arc_test.cpp", '#include "reference.hpp"\n')
        self.assertEqual(self.found(), [])
        self.write("tests/parser/wrong_test.cpp", '#include "reference.hpp"\n')
        self.assertEqual(len(self.found()), 1)

    def test_refuses_a_header_named_by_a_macro(self):
        self.write("curves/line.cpp", "#include HEADER\n")
        self.assertEqual(len(self.found()), 1)

    def test_is_not_fooled_by_comments(self):
        self.write("curves/line.cpp", '// as in #include "parser/move.hpp"\n')
        self.assertEqual(self.found(), [])

    def test_fails_as_a_command_too(self):
        command = [sys.executable, HERE / "includes.py", self.root]
        self.assertEqual(subprocess.run(command, capture_output=True, check=False).returncode, 0)
        self.write("curves/line.cpp", '#include "parser/move.hpp"\n')
        self.assertEqual(subprocess.run(command, capture_output=True, check=False).returncode, 1)


class PlaceRule(Checkout):
    def test_finds_a_home_and_a_workplace(self):
        self.write("README.md", "see " + "/home" + "/anna/kerf\n\n(" + "/work" + "/main)\n")
        self.assertEqual([line.split(" error")[0] for line in paths.findings(self.root)], ["README.md:1:", "README.md:3:"])

    def test_leaves_addresses_relative_paths_and_the_system_alone(self):
        self.write("README.md", "#!/bin/bash https://example.org/home/x ../work/y docs/root/z /usr/include /var/lib/dpkg\n")
        self.assertEqual(list(paths.findings(self.root)), [])


class ErrorPageRule(Checkout):
    def setUp(self):
        super().setUp()
        self.write("parser/arc.cpp", "fail(errors::kShort); fail(errors::kLong);\n")
        self.write("diagnostics/errors/catalogue.cpp", "in_order(kArcsPages)\n")
        self.topic("&kShort,\n  &kLong")

    def topic(self, names):
        self.write("diagnostics/errors/arcs.hpp", "inline constexpr ErrorPage kShort{1};\ninline constexpr ErrorPage kLong{2};\n"
                   f"inline constexpr std::array kArcsPages{{{names}}};\n")

    def found(self):
        return list(error_pages.findings(self.root))

    def test_accepts_pages_that_are_listed_and_used(self):
        self.assertEqual(self.found(), [])

    def test_finds_a_page_that_is_in_no_list(self):
        self.topic("&kShort")
        self.assertEqual(self.found(), ["diagnostics/errors/arcs.hpp:2: error: kLong is in no list of this file"])

    def test_finds_a_list_that_is_not_in_the_catalogue(self):
        self.write("diagnostics/errors/catalogue.cpp", "")
        self.assertEqual(self.found(), ["diagnostics/errors/arcs.hpp:1: error: kArcsPages is not in the catalogue"])

    def test_finds_a_page_that_nothing_gives(self):
        self.write("parser/arc.cpp", "fail(errors::kShort);\n")
        self.write("tests/parser/arc_test.cpp", "errors::kLong\n")
        self.assertEqual(self.found(), ["diagnostics/errors/arcs.hpp:2: error: nothing gives kLong"])


if __name__ == "__main__":
    unittest.main()
