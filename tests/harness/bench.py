"""A place for `make trials` with a stand-in for the program."""

import json
import os
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Bench:
    """A folder with a program and results of its own, and `make trials` run upon them."""

    def __init__(self, folder: Path):
        self.program = folder / "ldm"
        self.results = folder / "results"
        self.log = folder / "log"
        shutil.copy(ROOT / "tests" / "harness" / "fake_program.sh", self.program)

    def environment(self, **behaviour: str) -> dict[str, str]:
        """Without an outer Make's; `behaviour` is of the program: see fake_program.sh."""
        clean = {k: v for k, v in os.environ.items() if not k.startswith(("MAKE", "MFLAGS"))}
        return clean | {"LOG": str(self.log)} | behaviour

    def start(self, *variables: str, **behaviour: str) -> subprocess.Popen:
        return subprocess.Popen(
            ["make", "-C", ROOT, "trials", "STUDY=fake", f"LDM={self.program}",
             f"RESULTS={self.results}", "JOBS=2", *variables],
            env=self.environment(**behaviour), stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True, start_new_session=True)

    def run(self, *variables: str, **behaviour: str) -> subprocess.CompletedProcess:
        process = self.start(*variables, **behaviour)
        out, err = process.communicate(timeout=60)
        return subprocess.CompletedProcess(process.args, process.returncode, out, err)

    def records(self, folder: str = "fake") -> dict[str, dict]:
        files = (self.results / folder / "records").glob("[!.]*.json")  # a hidden one is unfinished
        return {file.name: json.loads(file.read_text()) for file in files}

    def ran(self) -> list[str]:
        """Trials started since the last call."""
        started = self.log.read_text().split() if self.log.exists() else []
        self.log.unlink(missing_ok=True)
        return sorted(started)

    def change_program(self) -> None:
        self.program.write_text(self.program.read_text() + "# another build\n")
