"""tests/rooms.py finds ways back, forbidden modules and rooms that are too full."""

import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[1] / "rooms.py"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A source tree whose includes and imports point one way."""
    write(tmp_path / "ldm/types.h")
    write(tmp_path / "ldm/machine/lanes.h")
    write(tmp_path / "ldm/map.cpp", '#include "ldm/map.h"\n#include "ldm/machine/lanes.h"\n#include <vector>\n')
    write(tmp_path / "ldm/map.h", '#include "ldm/types.h"\n')
    write(tmp_path / "experiments/runs/run.cpp", '#include "ldm/map.h"\n#include "not/of/this/tree.h"\n')
    write(tmp_path / "analysis/data/records.py")
    write(tmp_path / "analysis/tables/table1.py", "import csv\nfrom analysis.data import records\n")
    return tmp_path


def write(file: Path, text: str = "") -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text)


def run(tree: Path) -> subprocess.CompletedProcess:
    return subprocess.run(["/usr/bin/python3", SCRIPT, tree], capture_output=True, text=True)


def test_prints_each_room_with_those_it_includes(tree):
    done = run(tree)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines() == [
        "analysis/data: ", "analysis/tables: analysis/data", "experiments/runs: ldm", "ldm: ldm/machine", "ldm/machine: "]


def test_rooms_that_include_one_another_fail_and_are_located(tree):
    write(tree / "ldm/machine/lanes.h", '#include "ldm/types.h"\n')
    done = run(tree)
    assert done.returncode == 1
    assert done.stderr == ("rooms include one another: ldm -> ldm/machine (ldm/map.cpp), "
                           "ldm/machine -> ldm (ldm/machine/lanes.h)\n")


def test_a_way_back_over_a_third_room_fails(tree):
    write(tree / "ldm/machine/lanes.h", '#include "ldm/plain/ray.h"\n')
    write(tree / "ldm/plain/ray.h", '#include "ldm/types.h"\n')
    done = run(tree)
    assert done.returncode == 1
    assert "ldm/machine -> ldm/plain" in done.stderr and "ldm/plain -> ldm" in done.stderr


def test_a_python_import_upward_fails(tree):
    write(tree / "analysis/data/records.py", "def late():\n    import analysis.tables.table1\n")
    done = run(tree)
    assert done.returncode == 1
    assert "analysis/data -> analysis/tables (analysis/data/records.py)" in done.stderr


@pytest.mark.parametrize("file, included, module", [
    ("ldm/map.h", "experiments/runs/run.cpp", "experiments"), ("experiments/runs/run.cpp", "tests/oracle.h", "tests")])
def test_a_module_that_must_not_be_included_fails(tree, file, included, module):
    write(tree / "tests/oracle.h")
    write(tree / file, f'#include "{included}"\n')
    done = run(tree)
    assert done.returncode == 1
    assert f"{file}: {file.split('/')[0]}/ must not include {module}/\n" in done.stderr


def test_a_room_that_is_too_full_fails(tree):
    for n in range(21):  # with map and types 23, a file with its header once
        write(tree / f"ldm/unit{n}.h")
        write(tree / f"ldm/unit{n}.cpp")
    done = run(tree)
    assert done.returncode == 1
    assert done.stderr == "ldm: 23 units: allowed: 22\n"
    (tree / "ldm/types.h").rename(tree / "ldm/machine/types.h")
    write(tree / "ldm/map.h")
    assert run(tree).returncode == 0
