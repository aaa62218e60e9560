"""The estimate that `make reproduce-full` prints before it starts."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

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


def heed_ctrl_c():
    """What a shell starts in the background ignores it."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.mark.parametrize("script", [["list_studies.py"], ["estimate.py", "calibration", "--seeds", "1"]])
def test_ends_at_ctrl_c_with_one_line(tmp_path, script):
    started = tmp_path / "started"
    slow = tmp_path / "slow.sh"
    slow.write_text(f"#!/bin/sh\ntouch '{started}'\nexec sleep 20\n")
    slow.chmod(0o755)
    command = [sys.executable, ROOT / "experiments" / "harness" / script[0], *script[1:], "--program", slow,
               "--results", tmp_path, "--jobs", "2"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, preexec_fn=heed_ctrl_c) as process:
        while not started.exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        error = process.stderr.read()
    assert (process.returncode, error) == (130, "interrupted\n")
