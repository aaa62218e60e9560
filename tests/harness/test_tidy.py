"""tests/tidy.py: which sources clang-tidy is run on again."""
import json
import subprocess
import sys
from pathlib import Path

import pytest

TIDY = Path(__file__).resolve().parents[1] / "tidy.py"
# Finds fault with each source that says so, and keeps a list of those that it was asked about.
FAKE = """#!/bin/sh
cd "$(dirname "$0")"
[ "$1" != --version ] || { cat version; exit; }
echo "$(basename "$4")" >> asked
cp "$3/compile_commands.json" seen.json
if grep -q fault "$4"; then echo "$4: error: a fault"; exit 1; fi
"""


class Tree:
    """A room of two sources, one of which includes a header that includes another."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.write("datasets/deep.h", "")
        self.write("datasets/near.h", '#include "datasets/deep.h"\n')
        self.write("datasets/with.cpp", '#include "datasets/near.h"\n#include <vector>\n')
        self.write("datasets/alone.cpp", "")
        self.write("experiments/other.cpp", "")
        self.write(".clang-tidy", "Checks: a\n")
        self.write("tool/version", "14\n")
        self.write("tool/fake", FAKE)
        (root / "tool/fake").chmod(0o755)
        self.flags = "-O3"

    def write(self, name: str, text: str) -> None:
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def run(self, *options: str) -> subprocess.CompletedProcess[str]:
        """With a compile database that is written anew, as CMake does."""
        command = f"ccache g++ {self.flags} -Winvalid-pch -include {self.root}/pch.hxx -I{self.root} -c "
        self.write("build/compile_commands.json", json.dumps(
            [{"file": str(file), "directory": str(self.root), "command": command + str(file)}
             for file in sorted(self.root.glob("*/*.cpp"))]))
        (self.root / "tool/asked").write_text("")
        return subprocess.run(
            [sys.executable, TIDY, self.root / "build", "--root", self.root, "--cache", self.root / "../cache",
             "--clang-tidy", self.root / "tool/fake", *options],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def asked(self) -> list[str]:
        self.run()
        return sorted((self.root / "tool/asked").read_text().split())


@pytest.fixture
def tree(tmp_path: Path) -> Tree:
    made = Tree(tmp_path / "tree")
    assert made.asked() == ["alone.cpp", "with.cpp"]
    assert made.asked() == []
    return made


def test_another_clone_profits(tree: Tree, tmp_path: Path) -> None:
    assert Tree(tmp_path / "clone").asked() == []


@pytest.mark.parametrize("name", ["datasets/with.cpp", "datasets/near.h", "datasets/deep.h"])
def test_a_changed_source_or_header_is_checked_again(tree: Tree, name: str) -> None:
    before = (tree.root / name).read_text()
    tree.write(name, before + "int f();\n")
    assert tree.asked() == ["with.cpp"]
    tree.write(name, before)
    assert tree.asked() == []  # what passed once passes again


def test_what_all_sources_depend_on(tree: Tree) -> None:
    for change in (lambda: tree.write(".clang-tidy", "Checks: b\n"), lambda: tree.write("tool/version", "15\n"),
                   lambda: setattr(tree, "flags", "-O2")):
        change()
        assert tree.asked() == ["alone.cpp", "with.cpp"]


def test_findings_are_shown_until_they_are_mended(tree: Tree) -> None:
    tree.write("datasets/alone.cpp", "fault\n")
    for _ in range(2):
        run = tree.run("--jobs", "2")
        assert run.returncode == 1
        assert run.stderr == f"{tree.root}/datasets/alone.cpp: error: a fault\n\n"
        assert run.stdout == "clang-tidy: 1 of 2 sources checked, 1 with findings\n"
    tree.write("datasets/alone.cpp", "mended\n")
    assert tree.run().returncode == 0


def test_a_compile_database_from_before_a_source_went(tree: Tree) -> None:
    tree.run()
    database = tree.root / "build/compile_commands.json"
    database.write_text(database.read_text().replace("alone.cpp", "gone.cpp"))
    run = subprocess.run([sys.executable, TIDY, tree.root / "build", "--root", tree.root], text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert run.returncode == 2
    assert run.stderr == f"{database}: {tree.root}/datasets/gone.cpp: is no longer there: allowed: after cmake\n"


def test_without_precompiled_headers(tree: Tree) -> None:
    commands = [entry["command"] for entry in json.loads((tree.root / "tool/seen.json").read_text())]
    assert len(commands) == 2
    assert all("pch" not in command and "-O3" in command for command in commands)
