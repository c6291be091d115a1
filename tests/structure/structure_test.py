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
import browser  # noqa: E402
import error_pages  # noqa: E402
import front_door  # noqa: E402
import includes  # noqa: E402
import namesakes  # noqa: E402
import paths  # noqa: E402
import pictures  # noqa: E402
import references  # noqa: E402


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
        self.write("diagnostics/errors/pages.def", 'ERROR_PAGE(kShort, 1, error,\n  "short")\nERROR_PAGE(kLong, 2, error, "long")\n')
        self.write("parser/arc.cpp", "fail(errors::kShort); fail(errors::kLong);\n")

    def found(self):
        return list(error_pages.findings(self.root))

    def test_accepts_pages_that_are_used(self):
        self.assertEqual(self.found(), [])

    def test_finds_a_page_that_nothing_gives(self):
        self.write("parser/arc.cpp", "fail(errors::kShort);\n")
        self.write("tests/parser/arc_test.cpp", "errors::kLong\n")
        self.assertEqual(self.found(), ["diagnostics/errors/pages.def:3: error: nothing gives kLong"])

    def test_finds_a_line_that_is_too_long(self):
        self.write("diagnostics/errors/pages.def", "// " + "x" * 98 + "\n")
        self.assertEqual(self.found(), ["diagnostics/errors/pages.def:1: error: longer than 100 columns"])


class FrontDoorRule(Checkout):
    HEADER = """#pragma once
#define KERF_API __attribute__((visibility("default")))
KERF_API bool validate(const Settings& settings);  // as in old(1)
class KERF_API Kernel {
 public:
  explicit Kernel(const Settings& settings, const Options& options = {});
  ~Kernel();
  Kernel& operator=(Kernel&&) noexcept;
  [[nodiscard]] bool has_fault() const noexcept { return fault_.has_value(); }
  void feed(std::string_view text);

 private:
  void hidden();
  int count_ = 0;
};
struct Answer {
  int count = 0;
  constexpr bool is_accepted() const { if (count) { return false; } return true; }
};
constexpr int letter_bit(char letter) { return 1 << (letter - 'A'); }
"""
    PAGE = """| `Kernel` | thread | allocates |
| --- | --- | --- |
| `Kernel(settings, options)` | any | yes |
| `feed`, `has_fault` | any | yes |

| `function` | thread | allocates |
| --- | --- | --- |
| `validate`, `letter_bit` | any | yes |

| `Answer` | thread | allocates |
| --- | --- | --- |
| `is_accepted` | any | no |

| header | what it has |
| --- | --- |
| `kerf/kernel.hpp` | all |
"""

    def found(self, old="", new=""):
        self.write("include/kerf/kernel.hpp", self.HEADER)
        self.write("docs/embedding.md", self.PAGE.replace(old, new) if old else self.PAGE)
        return list(front_door.findings(self.root))

    def test_accepts_a_row_for_each_method_and_function(self):
        self.assertEqual(self.found(), [])

    def test_finds_a_method_without_a_row(self):
        self.assertEqual(self.found(", `has_fault`"), ["docs/embedding.md: error: says nothing of Kernel has_fault"])

    def test_finds_a_function_without_a_row(self):
        self.assertEqual(self.found("`validate`", "nothing"), ["docs/embedding.md: error: says nothing of function validate"])

    def test_finds_those_written_in_the_header_too(self):
        self.assertEqual(self.found(", `letter_bit`"), ["docs/embedding.md: error: says nothing of function letter_bit"])
        self.assertEqual(self.found("`is_accepted`", "nothing"), ["docs/embedding.md: error: says nothing of Answer is_accepted"])

    def test_finds_a_row_without_a_method(self):
        self.assertEqual(self.found("`feed`", "`feed`, `hidden`"), ["docs/embedding.md: error: there is no Kernel hidden"])


class NamesakeRule(Checkout):
    def setUp(self):
        super().setUp()
        self.write("parser/block.hpp", "namespace kerf::parser {\nstruct Block {\n  struct Part {\n  };\n};\n}\n")

    def found(self):
        return list(namesakes.findings(self.root))

    def test_accepts_types_with_names_of_their_own(self):
        self.write("lookahead/block.hpp", "struct PlanBlock {\n  struct Part {\n  };\n};\nstruct Block;\nusing Block = parser::Block;\n")
        self.write("lookahead/one.cpp", "struct Local {\n};\n")
        self.write("lookahead/two.cpp", "struct Local {\n};\n")
        self.assertEqual(self.found(), [])

    def test_finds_two_types_of_one_name_in_headers(self):
        self.write("lookahead/block.hpp", "namespace kerf::lookahead {\nclass Block final : public Base {\n};\n}\n")
        self.assertEqual(self.found(), ["lookahead/block.hpp:2: error: Block is the name of another type, in parser/block.hpp"])

    def test_finds_one_in_a_source_file_and_an_alias(self):
        self.write("smoothing/local.cpp", "\nenum class Block : char { none };\n")
        self.write("smoothing/other.cpp", "using Block = std::array<int, 3>;\n")
        self.assertEqual(self.found(), ["smoothing/local.cpp:2: error: Block is the name of another type, in parser/block.hpp",
                                        "smoothing/other.cpp:1: error: Block is the name of another type, in parser/block.hpp"])


class BrowserRule(Checkout):
    def setUp(self):
        super().setUp()
        self.write("web/kernel/CMakeLists.txt", "foreach(folder parser curves\n    kernel)\n")
        self.write("web/kernel/libcxx14.hpp", "constexpr auto find(Range&& range) {\nvoid stable_sort(Range&& range,\n  return copy(range);\n")

    def found(self):
        return list(browser.findings(self.root))

    def test_accepts_what_the_library_is_given(self):
        self.write("kernel/a.cpp", "std::ranges::find(a, b);\nstd::ranges::stable_sort(a);\n  assert(std::ranges::is_sorted(a));\n")
        self.write("bench/a.cpp", "std::ranges::equal(a, b);\n")
        self.assertEqual(self.found(), [])

    def test_finds_what_it_lacks(self):
        self.write("kernel/a.hpp", "\nreturn std::ranges::equal(a, b);\n")
        self.write("parser/a.cpp", "std::ranges::copy(a, b);\n")
        self.assertEqual(self.found(), ["parser/a.cpp:1: error: std::ranges::copy is not in web/kernel/libcxx14.hpp",
                                        "kernel/a.hpp:2: error: std::ranges::equal is not in web/kernel/libcxx14.hpp"])


class ReferenceRule(Checkout):
    PAGE = """# The mathematics

## 2. Profiles

### 2.4 Sine

Of [Sigmoid, section 2.2], in `sine`: `kPeak = 1.5`, see (2.1).

```math
T = 1 \\tag{2.1}
```

![One picture](pictures/sine.svg)

## References

- **[Sigmoid]** H. Li et al.: A method.
- **[NISTIR 6556]** T. Kramer: A report.
"""

    def setUp(self):
        super().setUp()
        self.write("docs/math.md", self.PAGE)
        self.write("docs/pictures/sine.svg", "<svg/>\n")
        self.write("profiles/sine.hpp", "constexpr double kPeak = 1.5;\n")

    def found(self):
        return list(references.findings(self.root))

    def comment(self, *lines):
        self.write("profiles/law.cpp", "int x;\n" + "".join(f"// {line}\n" for line in lines))
        return self.found()

    def page(self, old, new):
        self.assertIn(old, self.PAGE)
        self.write("docs/math.md", self.PAGE.replace(old, new))
        return self.found()

    def test_accepts_works_of_the_list_and_chapters_of_the_page(self):
        self.assertEqual(self.comment("As in [Sigmoid, section 2.2], [Sigmoid] and [NISTIR 6556, 3.5.3],", "docs/math.md, 2.4 and docs/math.md,", "2."), [])

    def test_finds_a_number_without_a_work(self):
        for words in ("section 5", "(Sigmoid, section 3.1)", "MATH section 5", "equations 2.5", "eq. (12)", "Eqn. 3", "table 4", "Figure 5", "fig. 2",
                      "chapter XIV", "§3", "appendix B"):
            with self.subTest(words=words):
                self.assertEqual(len(self.comment(f"as {words} says")), 1)

    def test_finds_one_that_is_broken_over_two_lines_and_names_the_line(self):
        self.assertEqual(self.comment("As MATH", "says in section", "5 of it."),
                         ["profiles/law.cpp:4: error: 'section 5' names no work; write [Work, section 5] or docs/math.md, N"])

    def test_finds_a_work_that_is_not_in_the_list(self):
        self.assertEqual(self.comment("As in [Sigmoids, section 2.2]."),
                         ["profiles/law.cpp:2: error: [Sigmoids, section 2.2] is not in the references of docs/math.md"])

    def test_finds_a_chapter_that_the_page_has_not(self):
        self.assertEqual(self.comment("docs/math.md, 2.5"), ["profiles/law.cpp:2: error: docs/math.md, 2.5 is no chapter of the page"])
        self.assertEqual(len(self.comment("see docs/math.md")), 1)

    def test_finds_all_of_them_where_the_page_has_gone(self):
        (self.root / "docs" / "math.md").unlink()
        self.assertEqual(len(self.comment("[Sigmoid, section 2.2], docs/math.md, 2.4")), 2)

    def test_looks_at_comments_only_and_at_all_of_them(self):
        self.write("profiles/law.cpp", 'int a; const char* text = "// section 5"; char c = \'"\'; auto raw = R"(// table 4)";\n')
        self.assertEqual(self.found(), [])
        self.write("profiles/law.cpp", "int a;  // section 5\n/* and\n   table 4 */\n")
        self.assertEqual([line.split(" error")[0] for line in self.found()], ["profiles/law.cpp:1:", "profiles/law.cpp:3:"])

    def test_leaves_brackets_that_cite_nothing_alone(self):
        self.assertEqual(self.comment("s in [0, 1], v[i], rows[k, 2], a table of 5, the section above, figures, equation"), [])

    def test_finds_what_the_page_names_and_nobody_has(self):
        for old, new in (("`sine`", "`cosine`"), ("`kPeak = 1.5`", "`kPeak = 1.6`"), ("(2.1)", "(2.2)"), ("sine.svg", "cosine.svg"),
                         ("[Sigmoid, section 2.2]", "[Sigmund, section 2.2]")):
            with self.subTest(new=new):
                self.assertEqual(len(self.page(old, new)), 1)


    def test_looks_for_a_constant_in_the_sources_named_beside_it(self):
        self.write("curves/other.cpp", "constexpr double kPeak = 1.6;\n")
        self.assertEqual(len(self.page("`kPeak = 1.5`", "`kPeak = 1.6`")), 1)
        self.assertEqual(self.page("`sine`: `kPeak = 1.5`", "`kPeak = 1.6`"), [])


class PictureRule(Checkout):
    def setUp(self):
        super().setUp()
        self.write("scripts/draw_math_pictures.py", "import pathlib, sys\npathlib.Path(sys.argv[1], 'a.svg').write_text('<svg/>')\n")
        self.write("docs/pictures/a.svg", "<svg/>")

    def test_accepts_what_the_script_draws(self):
        self.assertEqual(list(pictures.findings(self.root)), [])

    def test_finds_pictures_that_differ_are_missing_or_left_over(self):
        self.write("docs/pictures/a.svg", "<svg></svg>")
        self.assertEqual(len(list(pictures.findings(self.root))), 1)
        (self.root / "docs" / "pictures" / "a.svg").rename(self.root / "docs" / "pictures" / "b.svg")
        self.assertEqual(len(list(pictures.findings(self.root))), 2)


if __name__ == "__main__":
    unittest.main()
