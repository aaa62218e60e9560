"""Files are written whole or not at all, and a file that cannot be written is one line."""

import resource
import subprocess
import sys
from pathlib import Path

import pytest
from record_files import make_record, write_records

from analysis.data.output import write_text

ROOT = Path(__file__).resolve().parents[3]
SMALL = 3000
"""Of a file: the table fits, the figure does not [bytes]."""


def limit_files():
    resource.setrlimit(resource.RLIMIT_FSIZE, (SMALL, SMALL))


def test_a_figure_that_does_not_fit_leaves_no_file_and_one_line(tmp_path):
    records = [make_record("ldm", r, point={"particles.count": n}) for r in (1, 2) for n in (10, 20)]
    write_records(tmp_path, records)
    command = [sys.executable, "-m", "analysis.figures.sweep_figure", "--results", tmp_path, "--study", "table1"]
    done = subprocess.run(command, cwd=ROOT, preexec_fn=limit_files, capture_output=True, text=True, check=False)
    figures = tmp_path / "table1" / "figures"
    assert done.returncode == 1
    assert done.stderr == f"error: {figures}/table1.png: File too large\n"
    assert (tmp_path / "table1" / "tables" / "table1.txt").exists() and not list(figures.iterdir())


def test_an_older_file_stays_where_a_new_one_does_not_fit(tmp_path):
    file = tmp_path / "table.txt"
    write_text(file, "old")
    code = ("import pathlib, analysis.data.output as output; "
            f"output.write_text(pathlib.Path({str(file)!r}), 'x' * {2 * SMALL})")
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, preexec_fn=limit_files, capture_output=True,
                          text=True, check=False)
    assert done.returncode == 1 and "table.txt.part" not in done.stderr.splitlines()[-1]
    assert file.read_text() == "old" and [f.name for f in tmp_path.iterdir()] == ["table.txt"]


def test_the_error_names_the_file_and_not_a_temporary_one(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OSError) as raised:
        write_text(tmp_path / "file" / "table.txt", "text")
    assert raised.value.filename == str(tmp_path / "file" / "table.txt")
