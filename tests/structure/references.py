#!/usr/bin/env python3
"""What is cited can be found: papers and books in the list of docs/math.md, its chapters, and what it names of the sources.

    references.py ROOT      exit status 1 and one line a finding, in the form file:line: error: ...

Comments of C++ sources cite a work as [Sigmoid, section 3.1], with its short name in the list, and a chapter of the page as
docs/math.md, 4.3. A section, equation, table, figure or chapter with a number and without a work is a finding.
"""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from sources import cpp_files  # noqa: E402

PAGE = "docs/math.md"
NUMBER = r"\(?(?:[0-9][0-9.]*|[IVXL]+\b|[A-Z]\b)"
PLACE = re.compile(rf"§ ?[0-9]|\b(?i:sections?|chapters?|appendix|equations?|eqn?s?\.?|tables?|figures?|figs?\.) {NUMBER}")
CITATION = re.compile(r"\[([A-Z][\w .-]*\w)(, [^\][]*)?\]")
CHAPTER = re.compile(r"docs/math\.md(?:, ([0-9]+(?:\.[0-9]+)*))?")

HEADING = re.compile(r"^#{2,6} ([0-9]+(?:\.[0-9]+)*)\.? ", re.MULTILINE)
ENTRY = re.compile(r"^- \*\*\[([^\]]+)\]\*\* ", re.MULTILINE)
TAG = re.compile(r"\\tag\{([0-9.]+)\}")
FORMULA = re.compile(r"^```math\n.*?^```$|\$[^$\n]+\$", re.MULTILINE | re.DOTALL)
EQUATION = re.compile(r"\(([0-9]+\.[0-9]+)\)")
CODE = re.compile(r"`([^`\n]+)`")
PICTURE = re.compile(r"!\[[^\]]*\]\(([^)]+)\)")

# Comments and what only looks like them.
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^()\s]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)


def comments_of(text):
    """(line, text) of each comment; // lines that follow each other without code between are one."""
    found = []
    end = None
    for token in TOKEN.finditer(text):
        words = token.group()
        if words.startswith("//") and end is not None and text[end:token.start()].strip(" \t") == "\n":
            found[-1][1].append(words[2:])
            end = token.end()
        elif words.startswith("//"):
            found.append((text.count("\n", 0, token.start()) + 1, [words[2:]]))
            end = token.end()
        elif words.startswith("/*"):
            found.append((text.count("\n", 0, token.start()) + 1, words[2:-2].split("\n")))
            end = None
        else:
            end = None
    return found


class Page:
    """What docs/math.md offers."""

    def __init__(self, root):
        path = root / PAGE
        self.text = path.read_text(encoding="utf-8") if path.is_file() else ""
        self.headings = set(HEADING.findall(self.text))
        self.works = set(ENTRY.findall(self.text))
        self.equations = set(TAG.findall(self.text))


def unresolved(text, page):
    """What of one text with citations cannot be found."""
    for chapter in CHAPTER.finditer(text):
        if chapter.group(1) is None or chapter.group(1) not in page.headings:
            yield f"{chapter.group()} is no chapter of the page"
    for citation in CITATION.finditer(text):
        cites = citation.group(2) is not None or citation.group(1) in page.works
        if cites and citation.group(1) not in page.works:
            yield f"{citation.group()} is not in the references of {PAGE}"
    rest = CITATION.sub("", CHAPTER.sub("", text))
    for place in PLACE.finditer(rest):
        yield f"'{place.group()}' names no work; write [Work, {place.group()}] or {PAGE}, N"


def findings_in_comments(text, page):
    for first, lines in comments_of(text):
        for message in unresolved(" ".join(line.strip() for line in lines), page):
            # Of the lines of the comment the one that has the most of what is complained about.
            last_word = re.findall(r"[\w.]+", message.split(" is ")[0].split("' names")[0])[-1]
            line = next((k for k, words in enumerate(lines) if last_word in words), 0)
            yield first + line, message


def sources_by_line(text, stems):
    """For each line the sources that are named between the same two headings."""
    found, here = [], set()
    for line in text.split("\n"):
        here = set() if line.startswith("#") else here
        here.update(span for span in CODE.findall(line) if span in stems)
        found.append(here)
    return found


def is_said(constant, near, everywhere):
    """Of sources named near that have this constant all have this value; where none has it, any source has."""
    name = re.compile(rf"\b{constant.split(' ')[0]} = ")
    near = [text for text in near if name.search(text)]
    return all(f" {constant};" in text for text in near) if near else any(f" {constant};" in text for text in everywhere)


def findings_in_page(root, page):
    """Works, equations, pictures and names of the sources that the page names and that do not exist."""
    texts = {}  # by stem: of a header and its source
    for path in cpp_files(root):
        texts[path.stem] = texts.get(path.stem, "") + path.read_text(encoding="utf-8")
    words = set(texts).union(*(re.findall(r"\w+", text) for text in texts.values()))
    named = sources_by_line(page.text, texts)
    for number, line in enumerate(FORMULA.sub(lambda m: "\n" * m.group().count("\n"), page.text).split("\n"), 1):
        for message in unresolved(CODE.sub("", PICTURE.sub("", line)), page) if not ENTRY.match(line) else ():
            if "names no work" not in message:
                yield number, message
        for equation in EQUATION.findall(line):
            if equation not in page.equations:
                yield number, f"there is no equation ({equation})"
        for picture in PICTURE.findall(line):
            if not (root / PAGE).parent.joinpath(picture).is_file():
                yield number, f"there is no picture {picture}"
        for span in CODE.findall(line):
            if re.fullmatch(r"\w+ = \S+", span):
                if not is_said(span, [texts[stem] for stem in named[number - 1]], texts.values()):
                    yield number, f"no source says {span}"
            elif re.fullmatch(r"\w+", span) and span not in words:
                yield number, f"{span} is neither a file nor a name of the sources"
            elif "/" in span and "," not in span and not (root / span).exists():
                yield number, f"there is no file {span}"


def findings(root):
    root = pathlib.Path(root)
    page = Page(root)
    for path in cpp_files(root):
        for line, message in findings_in_comments(path.read_text(encoding="utf-8"), page):
            yield f"{path.relative_to(root)}:{line}: error: {message}"
    for line, message in findings_in_page(root, page):
        yield f"{PAGE}:{line}: error: {message}"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "every citation can be found")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
