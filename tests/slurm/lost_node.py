"""A study over a real Slurm gives the records of a local run, even if a node is lost in the middle.

`make test-slurm` runs it; not part of `make test`, whose pattern of file names it does not match.
"""

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from cluster import Cluster

ROOT = Path(__file__).resolve().parents[2]
FOLDER = "velocity-f200"


@pytest.fixture(name="cluster")
def started_cluster():
    cluster = Cluster()
    yield cluster
    cluster.stop()


def trials() -> int:
    """Of the study that `start_study` starts."""
    command = [os.environ["LDM"], "--data-dir", ROOT, "trials", "velocity", "--seeds", "4"]
    return len(subprocess.run(command, check=True, capture_output=True, text=True).stdout.splitlines())


def start_study(results: Path, environment: dict[str, str], *variables: str) -> subprocess.Popen:
    clean = {k: v for k, v in environment.items() if not k.startswith(("MAKE", "MFLAGS"))}
    return subprocess.Popen(
        ["make", "-C", ROOT, "trials", "STUDY=velocity", "SEEDS=4", "FRAMES=200",
         f"LDM={os.environ['LDM']}", f"RESULTS={results}", *variables],
        env=clean, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        start_new_session=True)


def finish(study: subprocess.Popen) -> subprocess.CompletedProcess:
    out, err = study.communicate(timeout=600)
    return subprocess.CompletedProcess(study.args, study.returncode, out, err)


def records(results: Path) -> dict[str, dict]:
    """All of each record but its times."""
    files = (results / FOLDER / "records").glob("*.s[0-9]*[0-9].json")
    return {file.name: json.loads(file.read_text()) | {"timing": None} for file in files}


def wait_for(condition, study: subprocess.Popen) -> None:
    deadline = time.monotonic() + 120
    while not condition():
        assert study.poll() is None and time.monotonic() < deadline, study.communicate()
        time.sleep(0.05)


def test_a_lost_node_costs_its_unfinished_trials_only(cluster, tmp_path):
    local = finish(start_study(tmp_path / "local", os.environ))
    assert local.returncode == 0, local.stderr

    over_slurm = tmp_path / "slurm"
    study = start_study(over_slurm, cluster.environment, "SLURM=1", "SHARDS=4")
    folder = over_slurm / FOLDER / "records"
    wait_for(lambda: len(list(folder.glob("*.s[0-9]*[0-9].json"))) >= 4 and cluster.running_trials("n2"), study)
    cluster.kill("n2")
    finished = {file: file.stat().st_mtime_ns for file in folder.glob("*.s[0-9]*[0-9].json")}
    assert 4 <= len(finished) < trials()

    done = finish(study)
    assert done.returncode == 0, done.stderr
    assert f"{trials()} of {trials()} trials good" in done.stdout
    assert cluster.node_states()["n2"] == "down*"
    assert {file: file.stat().st_mtime_ns for file in finished} == finished
    assert len(records(over_slurm)) == trials()
    assert records(over_slurm) == records(tmp_path / "local")


def test_an_interrupted_study_leaves_no_job_and_is_continued(cluster, tmp_path):
    study = start_study(tmp_path, cluster.environment, "SLURM=1", "SHARDS=2")
    folder = tmp_path / FOLDER
    wait_for(lambda: list(folder.glob("records/*.s[0-9]*[0-9].json")), study)
    second = finish(start_study(tmp_path, cluster.environment, "SLURM=1"))
    assert second.returncode != 0
    assert "another run is still writing" in second.stderr

    os.killpg(study.pid, signal.SIGINT)  # as Ctrl-C does
    interrupted = finish(study)
    assert interrupted.returncode != 0
    assert "stopped; the same command continues it" in interrupted.stderr
    assert cluster.jobs() == [] and not (folder / "slurm" / "job").exists()
    finished = {file: file.stat().st_mtime_ns for file in folder.glob("records/*.s[0-9]*[0-9].json")}
    assert 0 < len(finished) < trials()

    done = finish(start_study(tmp_path, cluster.environment, "SLURM=1", "SHARDS=2"))
    assert done.returncode == 0, done.stderr
    assert {file: file.stat().st_mtime_ns for file in finished} == finished


def test_a_job_that_outlives_its_submitter_keeps_others_out(cluster, tmp_path):
    environment = cluster.environment
    study = start_study(tmp_path, environment, "SLURM=1", "SHARDS=2", "SBATCH_FLAGS=--begin=now+1hour")
    job = tmp_path / FOLDER / "slurm" / "job"
    wait_for(job.exists, study)
    os.killpg(study.pid, signal.SIGKILL)
    study.communicate()

    refused = finish(start_study(tmp_path, environment))
    assert refused.returncode != 0
    (number,) = cluster.jobs()
    assert f"Slurm's job {number} is still writing" in refused.stderr
    subprocess.run(["scancel", number], env=environment, check=True)
    assert finish(start_study(tmp_path, environment, "SLURM=1", "SEEDS=1")).returncode == 0
