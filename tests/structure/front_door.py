#!/usr/bin/env python3
"""The tables of docs/embedding.md have every method and function that include/kerf offers, and no other.

    front_door.py ROOT      exit status 1 and one line a finding

A table's first heading names the class, or says `function`; its first column has the names in backticks.
"""
import pathlib
import re
import sys

PAGE = "docs/embedding.md"
NO_CODE = re.compile(r"//[^\n]*|/\*.*?\*/|^#[^\n]*", re.DOTALL | re.MULTILINE)
CLASS = re.compile(r"^(class|struct) (?:KERF_API )?(\w+)[^;{]*\{(.*?)\n\};", re.DOTALL | re.MULTILINE)
FUNCTION = re.compile(r"^(?:KERF_API|constexpr|inline) [^;{(=]*?\b(\w+)\(", re.MULTILINE)
BRACES = re.compile(r"\{[^{}]*\}")
ANGLES = re.compile(r"<[^<>]*>")
ROW = re.compile(r"^\| (.*?) \|", re.MULTILINE)
NAME = re.compile(r"`(\w+)(?:\([^`]*\))?`")


def public_part(kind, body):
    """What stands after public:, up to the next private: or protected:."""
    parts = re.split(r"^ (public|private|protected):$", body, flags=re.MULTILINE)
    access = "public" if kind == "struct" else "private"
    found = parts[0] if access == "public" else ""
    for label, text in zip(parts[1::2], parts[2::2]):
        found += text if label == "public" else ""
    return found


def declared_names(body):
    """Of methods: the name before the first bracket of each declaration at the body's own level."""
    while BRACES.search(body):
        body = BRACES.sub(";", body)
    while ANGLES.search(body):
        body = ANGLES.sub("", body)
    for declaration in body.split(";"):
        declaration = re.sub(r"\[\[\w+\]\]", "", declaration)
        if "(" not in declaration or "friend" in declaration or "operator" in declaration or "= delete" in declaration or "=" in declaration.split("(")[0]:
            continue
        name = re.search(r"(~?\w+) ?\(", declaration).group(1)
        if not name.startswith("~"):
            yield name


def offered(root):
    """{class name or 'function': {names}}"""
    found = {"function": set()}
    for header in sorted((root / "include/kerf").glob("*.hpp")):
        text = NO_CODE.sub("", header.read_text(encoding="utf-8"))
        for kind, name, body in CLASS.findall(text):
            names = set(declared_names(public_part(kind, body)))
            if names:
                found.setdefault(name, set()).update(names)
        found["function"].update(FUNCTION.findall(text))
    return found


def told(root):
    """The same of the page, with lists in place of sets."""
    found = {}
    table = None
    for row in (root / PAGE).read_text(encoding="utf-8").split("\n"):
        cell = ROW.match(row)
        if not cell:
            table = None
        elif table is None:
            heading = cell.group(1).strip("`")
            table = found.setdefault(heading, []) if "| thread |" in row else []
        else:
            table += NAME.findall(cell.group(1))
    return found


def findings(root):
    root = pathlib.Path(root)
    page = told(root)
    door = offered(root)
    for owner in sorted(set(door) | set(page)):
        names = page.get(owner, [])
        for name in sorted(door.get(owner, set()) - set(names)):
            yield f"{PAGE}: error: says nothing of {owner} {name}"
        for name in sorted(set(names) - door.get(owner, set())):
            yield f"{PAGE}: error: there is no {owner} {name}"
        for name in sorted({name for name in names if names.count(name) > 1}):
            yield f"{PAGE}: error: has {owner} {name} twice"


def main():
    found = list(findings(sys.argv[1]))
    print("\n".join(found) or "every method has its row")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
