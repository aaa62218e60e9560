"""The progress of a study on a terminal and elsewhere."""

import os
import pty
import subprocess
import sys
import termios

from bench import ROOT

COUNT = """
import time, progress
with progress.Progress("study s", 3) as shown:
    for failed in (False, True, False):
        time.sleep(0.3)
        shown.show()
        shown.count(failed)
"""


def run(**kwargs) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, "-c", COUNT], cwd=ROOT / "experiments" / "harness", check=True, **kwargs)


def test_a_terminal_shows_a_bar_with_failures_and_an_estimate():
    ours, theirs = pty.openpty()
    termios.tcsetwinsize(theirs, (24, 100))
    run(stderr=theirs)
    os.close(theirs)
    shown = os.read(ours, 65536).decode()
    last = shown.split("\r")[-2]
    assert "study s: 3/3, 1 failed, 00:0" in last and "00:00 left" in last
    assert any("study s: 1/3, 00:00 so far, 00:0" in state for state in shown.split("\r"))


def test_elsewhere_a_short_study_is_silent():
    assert run(stderr=subprocess.PIPE, text=True).stderr == ""


def test_elsewhere_lines_come_now_and_then():
    code = COUNT.replace("import time, progress", "import time, progress\nprogress.LINE_INTERVAL_S = 0.2")
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT / "experiments" / "harness", check=True,
                          stderr=subprocess.PIPE, text=True)
    lines = done.stderr.splitlines()
    assert any(line.startswith("study s: 1/3, 00:00 so far, 00:0") for line in lines) and "\r" not in done.stderr
    assert all(line.startswith("study s: ") for line in lines) and "1 failed" in lines[-1]
