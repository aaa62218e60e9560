"""What `make bench` leaves where its file cannot be written: nothing, and one line."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "experiments" / "benchmarks"))

from bench import write  # noqa: E402


def test_the_file_is_written_as_a_whole(tmp_path):
    assert write(tmp_path / "results" / "bench.json", "{}\n") == 0
    assert [file.name for file in (tmp_path / "results").iterdir()] == ["bench.json"]
    assert (tmp_path / "results" / "bench.json").read_text() == "{}\n"


def test_a_place_that_cannot_be_written_is_one_line(tmp_path, capsys):
    (tmp_path / "results").write_text("a file")
    file = tmp_path / "results" / "bench.json"
    assert write(file, "{}\n") == 1
    assert capsys.readouterr().err == f"bench: {file}: File exists\n"
