"""The estimate that `make reproduce-full` prints before it starts."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def estimate(results: Path, program: Path, *options: str) -> str:
    command = [sys.executable, ROOT / "experiments" / "harness" / "estimate.py", "calibration", "--program", program,
               "--results", results, "--jobs", "2", *options]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_counts_what_is_missing_at_the_measured_pace(tmp_path):
    program = ROOT / "tests" / "harness" / "fake_program.sh"
    assert "10 trials to run" in estimate(tmp_path, program, "--seeds", "10")
    records = tmp_path / "calibration" / "records"
    records.mkdir(parents=True)
    for trial in ("t1", "t2"):
        (records / f"{trial}.json").write_text("{}")
    (tmp_path / "calibration" / "MANIFEST").write_text("cpu_s_per_trial 5.000\n")
    found = estimate(tmp_path, program, "--seeds", "10")
    assert "8 trials to run  20 s\n" in found and "together about 20 s on 2 cores" in found
    serial = estimate(tmp_path, program, "--seeds", "10", "--serial", "calibration")
    assert "together about 40 s" in serial
