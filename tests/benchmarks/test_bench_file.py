"""What `make bench` leaves where its file cannot be written: nothing, and one line."""

import importlib.util
import sys
from pathlib import Path

SCRIPTS = Path(__file__).resolve().parents[2] / "experiments" / "benchmarks"
sys.path.insert(0, str(SCRIPTS))

# By its path: the harness's tests have a module of that name, too.
_spec = importlib.util.spec_from_file_location("bench_script", SCRIPTS / "bench.py")
script = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(script)


def test_the_file_is_written_as_a_whole(tmp_path):
    assert script.write(tmp_path / "results" / "bench.json", "{}\n") == 0
    assert [file.name for file in (tmp_path / "results").iterdir()] == ["bench.json"]
    assert (tmp_path / "results" / "bench.json").read_text() == "{}\n"


def test_a_place_that_cannot_be_written_is_one_line(tmp_path, capsys):
    (tmp_path / "results").write_text("a file")
    file = tmp_path / "results" / "bench.json"
    assert script.write(file, "{}\n") == 1
    assert capsys.readouterr().err == f"bench: {file}: File exists\n"
