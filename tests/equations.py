"""The index of the paper's equations: where each is in plain words, where in the fast code, and its test.

A tag is `Eq. (N)` in a comment before, or on the line of, a declaration or a statement. Equations 1 to 17
are the method's: each is tagged once in ldm/plain/, which computes it as the paper writes it, and once in
the rest of ldm/; equation 18 is a score and is tagged once in experiments/. The comment at the head of a
file, which says what the file is about, holds no tags. Each equation has a test that names it, in the
tests' folder of the same name. Exit code 1 if anything of this fails.
"""

from __future__ import annotations

import argparse
import json
import re
import sys
from pathlib import Path
from typing import Iterator, NamedTuple

PLAIN = "ldm/plain"
METHOD = range(1, 18)
HOME = {**{number: "ldm" for number in METHOD}, 18: "experiments"}
TAG = re.compile(r"Eq\. \((\d+)\)")
COMMENT = re.compile(r"//.*")
TEST = re.compile(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\((\w+),\s*(\w+)\)")
NAME = re.compile(
    r"(?:class|struct|enum class|using|constexpr \w+)\s+(\w+)"  # a type or a constant
    r"|(\w+|operator\S+)\s*\("  # a function
    r"|(\w+)\s*(?:=|;|\{|\[)"  # a variable or a member
)


class Place(NamedTuple):
    file: Path
    line: int
    symbol: str

    def __str__(self) -> str:
        return f"{self.file}:{self.line}"


def head_length(lines: list[str]) -> int:
    """Number of lines of the comment at the head of a file, with `#pragma once`."""
    for number, line in enumerate(lines):
        if not line.startswith(("//", "#pragma once")):
            return number
    return len(lines)


def tags(lines: list[str]) -> Iterator[tuple[int, int]]:
    """(equation, index of its line) for each tag after the head."""
    for index in range(head_length(lines), len(lines)):
        comment = COMMENT.search(lines[index])
        for tag in TAG.finditer(comment.group() if comment else ""):
            yield int(tag.group(1)), index


def code_at(lines: list[str], index: int) -> str:
    """The code on line `index` or, after comments and templates, below it."""
    code = (COMMENT.sub("", line).strip() for line in lines[index:])
    return next((line for line in code if line and not line.startswith("template")), "-")


def declared(lines: list[str], index: int) -> str:
    """Name of what is declared there."""
    code = code_at(lines, index)
    match = NAME.search(code)
    return next(filter(None, match.groups())) if match else code


def enclosing_test(lines: list[str], index: int) -> str | None:
    """The test around line `index`, or the one that a comment outside any test stands before."""
    inside = lines[index].startswith((" ", "TEST"))
    candidates = reversed(lines[: index + 1]) if inside else lines[index:]
    for line in candidates:
        match = TEST.match(line)
        if match:
            return f"{match.group(1)}.{match.group(2)}"
    return None


def sources(folder: Path) -> list[Path]:
    return sorted(file for file in folder.rglob("*") if file.suffix in (".h", ".cpp"))


Places = dict[int, list[Place]]  # of each equation


class Index(NamedTuple):
    plain: Places  # their symbol is the code
    fast: Places  # scores included
    tests: Places


def index_of(root: Path) -> Index:
    """Declarations and tests of each equation below `root`."""
    index = Index(*({number: [] for number in HOME} for _ in Index._fields))
    for folder in sorted(set(HOME.values())):
        for file in sources(root / folder):
            lines = file.read_text(encoding="utf-8").splitlines()
            is_plain = file.is_relative_to(root / PLAIN)
            for number, line in tags(lines):
                symbol = (code_at if is_plain else declared)(lines, line)
                place = Place(file.relative_to(root), line + 1, symbol)
                (index.plain if is_plain else index.fast).setdefault(number, []).append(place)
        for file in sources(root / "tests" / folder):
            lines = file.read_text(encoding="utf-8").splitlines()
            for line, text in enumerate(lines):
                for tag in TAG.finditer(text):
                    test = enclosing_test(lines, line)
                    if test and HOME.get(int(tag.group(1))) == folder:
                        place = Place(file.relative_to(root), line + 1, test)
                        index.tests[int(tag.group(1))].append(place)
    return index


def misplaced(number: int, home: str, places: list[Place]) -> list[str]:
    """A line unless an equation has one tag, in its home."""
    where = ", ".join(map(str, places))
    if len(places) != 1:
        return [f"Eq. ({number}): one tag wanted in {home}/, found {len(places)}: {where or '-'}"]
    if places[0].file.parts[0] != home.split("/")[0]:
        return [f"Eq. ({number}): belongs to {home}/, tagged in {where}"]
    return []


def faults(index: Index) -> list[str]:
    """A line for each missing, doubled or misplaced tag and each equation without a test."""
    found = []
    for number in sorted({*index.plain, *index.fast}):
        if number not in HOME:
            where = ", ".join(map(str, index.plain.get(number, []) + index.fast.get(number, [])))
            found.append(f"Eq. ({number}): the paper has no such equation: {where}")
            continue
        found += misplaced(number, HOME[number], index.fast[number])
        if number in METHOD or index.plain[number]:
            found += misplaced(number, PLAIN if number in METHOD else HOME[number], index.plain[number])
        if not index.tests[number]:
            found.append(f"Eq. ({number}): no test in tests/{HOME[number]}/ names it")
    return found


def as_json(index: Index) -> str:
    """A row for each equation: `number`, and `file`, `line`, `symbol` of the first of each kind of place."""
    rows = []
    for number in HOME:
        row: dict[str, object] = {"number": number}
        for name, places in zip(Index._fields, index):
            for place in places[number][:1]:
                row[name] = place._asdict() | {"file": str(place.file)}
        rows.append(row)
    return json.dumps(rows, indent=1)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parents[1])
    parser.add_argument("--json", action="store_true", help="print the index for programs")
    args = parser.parse_args()
    index = index_of(args.root)
    if args.json:
        print(as_json(index))
    for number in HOME if not args.json else ():
        print(f"Eq. ({number})")
        for name, places in zip(Index._fields, index):
            for place in places[number][:1]:
                print(f"  {name:<6} {str(place):<48} {place.symbol}")
    found = faults(index)
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
