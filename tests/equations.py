"""The index of the paper's equations: number, symbol, file, test; `make equations`.

A tag is `Eq. (N)` in a comment before, or on the line of, a declaration. Equations 1 to 17 are the
method's and are tagged once each in ldm/; equation 18 is a score and is tagged once in experiments/.
The comment at the head of a file, which says what the file is about, holds no tags. Each equation
has a test that names it, in the tests' folder of the same name. Exit code 1 if anything of this fails.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Iterator, NamedTuple

HOME = {**{number: "ldm" for number in range(1, 18)}, 18: "experiments"}
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


def declared(lines: list[str], index: int) -> str:
    """Name of what is declared on line `index` or, after comments and templates, below it."""
    for line in lines[index:]:
        code = COMMENT.sub("", line).strip()
        if code and not code.startswith("template"):
            match = NAME.search(code)
            return next(filter(None, match.groups())) if match else code
    return "-"


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


def index_of(root: Path) -> tuple[dict[int, list[Place]], dict[int, list[Place]]]:
    """Declarations and tests of each equation below `root`."""
    declarations: dict[int, list[Place]] = {number: [] for number in HOME}
    tests: dict[int, list[Place]] = {number: [] for number in HOME}
    for folder in sorted(set(HOME.values())):
        for file in sources(root / folder):
            lines = file.read_text(encoding="utf-8").splitlines()
            for number, line in tags(lines):
                place = Place(file.relative_to(root), line + 1, declared(lines, line))
                declarations.setdefault(number, []).append(place)
        for file in sources(root / "tests" / folder):
            lines = file.read_text(encoding="utf-8").splitlines()
            for index, line in enumerate(lines):
                for tag in TAG.finditer(line):
                    test = enclosing_test(lines, index)
                    if test and HOME.get(int(tag.group(1))) == folder:
                        place = Place(file.relative_to(root), index + 1, test)
                        tests[int(tag.group(1))].append(place)
    return declarations, tests


def faults(declarations: dict[int, list[Place]], tests: dict[int, list[Place]]) -> list[str]:
    """A line for each missing, doubled or misplaced tag and each equation without a test."""
    found = []
    for number, places in sorted(declarations.items()):
        home = HOME.get(number)
        where = ", ".join(map(str, places))
        if home is None:
            found.append(f"Eq. ({number}): the paper has no such equation: {where}")
        elif len(places) != 1:
            found.append(f"Eq. ({number}): one tag wanted in {home}/, found {len(places)}: {where or '-'}")
        elif places[0].file.parts[0] != home:
            found.append(f"Eq. ({number}): belongs to {home}/, tagged in {where}")
        if home and not tests[number]:
            found.append(f"Eq. ({number}): no test in tests/{home}/ names it")
    return found


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]
    declarations, tests = index_of(root)
    print(f"{'Eq.':<5} {'symbol':<26} {'declared in':<36} test")
    for number in HOME:
        place = next(iter(declarations[number]), None)
        test = next(iter(tests[number]), None)
        print(f"{number:<5} {place.symbol if place else '-':<26} {str(place or '-'):<36} "
              f"{test.symbol if test else '-'}")
    found = faults(declarations, tests)
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
