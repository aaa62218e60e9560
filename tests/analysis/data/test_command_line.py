"""Every script: --help, and one clear line with exit code 2 where there is nothing to read."""

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

from analysis.data.command_line import run

SCRIPTS = ["tables.table1", "tables.velocity", "tables.compare", "figures.velocity_figures",
           "figures.computation_time", "figures.sweep_figure"]
ROOT = Path(__file__).resolve().parents[3]


@pytest.mark.parametrize("name", [*SCRIPTS, "figures.figure5"])
def test_help_shows_what_is_read_written_and_an_example(name, capsys):
    with pytest.raises(SystemExit) as ended:
        importlib.import_module(f"analysis.{name}").main(["--help"])
    assert ended.value.code == 0
    text = capsys.readouterr().out
    assert "--results DIR" in text and "--study NAME" in text
    assert "Writes" in text and f"Example: /usr/bin/python3 -m analysis.{name} " in text


@pytest.mark.parametrize("name", SCRIPTS)
def test_no_records_is_one_line(name, tmp_path, capsys):
    main = importlib.import_module(f"analysis.{name}").main
    assert run(main, ["--results", str(tmp_path), "--study", "nothing"]) == 2
    error = capsys.readouterr().err
    assert error.startswith(f"error: {tmp_path}/nothing/records: holds no record")
    assert error.count("\n") == 1


def test_as_a_program(tmp_path):
    command = [sys.executable, "-m", "analysis.tables.table1", "--results", str(tmp_path)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith("error: ") and "Traceback" not in done.stderr


def test_an_interruption_is_one_line(capsys):
    def interrupted(_argv):
        raise KeyboardInterrupt

    assert run(interrupted, []) == 130
    assert capsys.readouterr().err == "interrupted: the same command makes all of it anew\n"
