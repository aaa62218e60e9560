"""experiments/method/build_stamp.cmake: which commit a program says it was built from."""
import subprocess
from pathlib import Path

import pytest

METHOD = Path(__file__).resolve().parents[2] / "experiments" / "method"


class Tree:
    """A repository of one file of the method, one document and one script."""

    def __init__(self, root: Path) -> None:
        self.root = root
        for name in ("ldm/map.cpp", "README.md", "experiments/harness/run_study.py", "experiments/RECORD.md"):
            self.write(name, "first")
        self.git("init", "--quiet")
        self.commit()

    def write(self, name: str, text: str) -> None:
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def git(self, *words: str) -> str:
        author = ["-c", "user.name=test", "-c", "user.email=test@localhost"]
        return subprocess.run(["git", *author, *words], cwd=self.root, check=True,
                              stdout=subprocess.PIPE, text=True).stdout.strip()

    def commit(self) -> str:
        self.git("add", "--all")
        self.git("commit", "--quiet", "--message", "test")
        return self.git("rev-parse", "HEAD")

    def stamp(self) -> str:
        header = self.root.parent / "stamp.h"
        subprocess.run(
            ["cmake", f"-DSOURCE_DIR={self.root}", f"-DTEMPLATE={METHOD / 'build_stamp.h.in'}",
             f"-DHEADER={header}", "-DVERSION=1", "-DCOMPILER=c", "-DFLAGS=-O3", "-DBUILD_TYPE=Release",
             "-P", METHOD / "build_stamp.cmake"], check=True)
        return header.read_text(encoding="utf-8")


@pytest.fixture
def tree(tmp_path: Path) -> Tree:
    return Tree(tmp_path / "tree")


@pytest.mark.parametrize("name", ["README.md", "experiments/harness/run_study.py", "experiments/RECORD.md"])
def test_what_is_not_in_the_program_leaves_the_stamp(tree: Tree, name: str) -> None:
    before = tree.stamp()
    tree.write(name, "second")
    assert tree.stamp() == before
    tree.commit()
    assert tree.stamp() == before


def test_code_marks_it_changed_and_then_names_the_new_commit(tree: Tree) -> None:
    before = tree.stamp()
    tree.write("ldm/map.cpp", "second")
    assert "true" in tree.stamp() and "true" not in before
    commit = tree.commit()
    assert commit in tree.stamp() and "true" not in tree.stamp()


def test_outside_of_git_the_commit_is_unknown(tree: Tree) -> None:
    (tree.root / ".git").rename(tree.root.parent / "git")
    assert '"unknown"' in tree.stamp()
