"""tests/equations.py finds what is missing, doubled or untested."""

import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[1] / "equations.py"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A source tree in which every equation has its tag and its test."""
    for folder in ("ldm/plain", "experiments", "tests/ldm", "tests/experiments"):
        (tmp_path / folder).mkdir(parents=True)
    method = "\n".join(f"/// Text.  Eq. ({n})\ndouble f{n}(double x);" for n in range(1, 18))
    (tmp_path / "ldm/method.h").write_text(f"#pragma once\n/// Head: Eq. (3)-(5).\n\n{method}\n")
    plain = "".join(f"  x{n} += y;  // Text.  Eq. ({n})\n" for n in range(1, 18))
    (tmp_path / "ldm/plain/method.cpp").write_text(f"// Head: Eq. (3).\n\nvoid f() {{\n{plain}}}\n")
    tests = "\n".join(f"// Eq. ({n})\nTEST(Method, F{n}) {{\n}}" for n in range(1, 18))
    (tmp_path / "tests/ldm/method_test.cpp").write_text(tests)
    (tmp_path / "experiments/score.h").write_text("#pragma once\nint hits;  ///< Eq. (18)\n")
    (tmp_path / "tests/experiments/score_test.cpp").write_text(
        "TEST(Score, Hits) {\n  // Eq. (18) by hand\n}\n")
    return tmp_path


def run(tree: Path) -> subprocess.CompletedProcess:
    return subprocess.run(["/usr/bin/python3", SCRIPT, tree], capture_output=True, text=True)


def append(file: Path, text: str) -> None:
    file.write_text(file.read_text() + text)


def test_prints_plain_and_fast_home_and_test(tree):
    done = run(tree)
    assert (done.returncode, done.stderr) == (0, "")
    blocks = [block.split() for block in done.stdout.split("Eq. ")[1:]]
    assert blocks[10] == ["(11)", "plain", "ldm/plain/method.cpp:14", "x11", "+=", "y;",
                          "fast", "ldm/method.h:24", "f11", "tests", "tests/ldm/method_test.cpp:31", "Method.F11"]
    assert blocks[17] == ["(18)", "fast", "experiments/score.h:2", "hits",
                          "tests", "tests/experiments/score_test.cpp:2", "Score.Hits"]


def test_an_equation_without_plain_words_fails(tree):
    file = tree / "ldm/plain/method.cpp"
    file.write_text(file.read_text().replace("Eq. (7)", "see eq. 7"))
    done = run(tree)
    assert done.returncode == 1
    assert done.stderr == "Eq. (7): one tag wanted in ldm/plain/, found 0: -\n"


def test_a_score_in_plain_words_fails(tree):
    append(tree / "ldm/plain/method.cpp", "int hits;  // Eq. (18)\n")
    done = run(tree)
    assert done.returncode == 1
    assert done.stderr == "Eq. (18): belongs to experiments/, tagged in ldm/plain/method.cpp:22\n"


def test_a_missing_tag_fails(tree):
    file = tree / "ldm/method.h"
    file.write_text(file.read_text().replace("Eq. (7)", "see eq. 7"))
    done = run(tree)
    assert done.returncode == 1
    assert done.stderr == "Eq. (7): one tag wanted in ldm/, found 0: -\n"


def test_a_doubled_tag_fails_and_is_located(tree):
    append(tree / "ldm/method.h", "/// Eq. (7)\nint again;\n")
    done = run(tree)
    assert done.returncode == 1
    assert done.stderr == "Eq. (7): one tag wanted in ldm/, found 2: ldm/method.h:16, ldm/method.h:38\n"


def test_a_tag_in_code_is_no_tag(tree):
    append(tree / "ldm/method.h", 'auto text = "Eq. (7)";\n')
    assert run(tree).returncode == 0


def test_a_misplaced_and_an_unknown_tag_fail(tree):
    (tree / "ldm/score.h").write_text((tree / "experiments/score.h").read_text())
    (tree / "experiments/score.h").write_text("#pragma once\nint hits;  ///< Eq. (19)\n")
    done = run(tree)
    assert done.returncode == 1
    assert "Eq. (18): belongs to experiments/, tagged in ldm/score.h:2" in done.stderr
    assert "Eq. (19): the paper has no such equation" in done.stderr


def test_an_untested_equation_fails(tree):
    file = tree / "tests/ldm/method_test.cpp"
    file.write_text(file.read_text().replace("Eq. (12)", "equation twelve"))
    done = run(tree)
    assert done.returncode == 1
    assert done.stderr == "Eq. (12): no test in tests/ldm/ names it\n"
