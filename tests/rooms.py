"""Which room includes which: the folders of the C++ and Python sources, and that no way leads back.

A room is a folder with sources; the folders in it are rooms of their own. Within a top-level folder
includes (in Python: imports) between rooms point one way, and between the top-level folders they point
only where MODULES allows. A room holds at most MOST_UNITS units: a unit is a file with its header.
Prints each room with those it includes; exit code 1 if anything of this fails.
"""

from __future__ import annotations

import re
import sys
from collections import defaultdict
from pathlib import Path

MODULES = {"ldm": set(), "baselines": {"ldm"}, "datasets": {"ldm"},
           "experiments": {"ldm", "baselines", "datasets"}, "analysis": set()}
MOST_UNITS = 22
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
IMPORT = re.compile(r"^\s*(?:from (analysis[\w.]*) import (\w+)|import (analysis[\w.]*))", re.MULTILINE)


def sources(root: Path) -> list[Path]:
    return sorted(file.relative_to(root) for module in MODULES for file in (root / module).rglob("*")
                  if file.suffix in (".h", ".cpp", ".py"))


def included(root: Path, file: Path) -> list[Path]:
    """What of this tree a source includes or imports."""
    text = (root / file).read_text(encoding="utf-8")
    if file.suffix != ".py":
        return [Path(name) for name in INCLUDE.findall(text) if (root / name).is_file()]
    found = []
    for package, name, module in IMPORT.findall(text):
        stem = Path((module or package).replace(".", "/"))
        inner = (stem / name).with_suffix(".py") if name else None
        outer = stem / "__init__.py" if (root / stem).is_dir() else stem.with_suffix(".py")
        found.append(inner if inner and (root / inner).is_file() else outer)
    return found


def rooms_of(root: Path) -> dict[Path, dict[Path, Path]]:
    """Each room, and the rooms that it includes, each with a source that does."""
    rooms: dict[Path, dict[Path, Path]] = defaultdict(dict)
    for file in sources(root):
        rooms[file.parent]  # a room even if it includes nothing
        for other in included(root, file):
            if other.parent != file.parent:
                rooms[file.parent].setdefault(other.parent, file)
    return rooms


def cycle(rooms: dict[Path, dict[Path, Path]]) -> list[Path]:
    """Rooms that include one another in a ring, the first again at the end; empty if there are none."""
    done: set[Path] = set()

    def visit(room: Path, way: list[Path]) -> list[Path]:
        if room in way:
            return [*way[way.index(room):], room]
        if room in done:
            return []
        for other in rooms.get(room, {}):
            if found := visit(other, [*way, room]):
                return found
        done.add(room)
        return []

    return next((found for room in rooms if (found := visit(room, []))), [])


def faults(root: Path) -> list[str]:
    """A line for each way back, each forbidden way between modules, and each room that is too full."""
    rooms = rooms_of(root)
    found = []
    if ring := cycle(rooms):
        ways = (f"{a} -> {b} ({rooms[a][b]})" for a, b in zip(ring, ring[1:]))
        found.append("rooms include one another: " + ", ".join(ways))
    for room, others in rooms.items():
        for other, file in others.items():
            module, wanted = room.parts[0], other.parts[0]
            if wanted != module and wanted not in MODULES[module]:
                found.append(f"{file}: {module}/ must not include {wanted}/")
    units = defaultdict(set)
    for file in sources(root):
        units[file.parent].add(file.stem)
    found += [f"{room}: {len(names)} units: allowed: {MOST_UNITS}"
              for room, names in units.items() if len(names) > MOST_UNITS]
    return found


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]
    for room, others in sorted(rooms_of(root).items()):
        print(f"{room}: {' '.join(map(str, sorted(others)))}")
    found = faults(root)
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
