"""A study's folder of results: which trials it has, which ended well, what made them.

    records/ID.json   one for each finished trial, good or failed (RECORD.md)
    MANIFEST          what made the records, and how long they took
    lock              held by whoever runs the study
    slurm/            shares and logs of a run over Slurm
"""

import argparse
import fcntl
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


class Study:
    """A study and its folder; with `method`, of that method instead of the study's own."""

    def __init__(self, args: argparse.Namespace, method: str | None = None):
        self.name = args.study
        self.program = args.program
        self.size = ["--seeds", str(args.seeds)] if args.seeds else []
        self.size += ["--frames", str(args.frames)] if args.frames else []
        self.size += ["--method", method] if method else []
        # Shortened runs have a folder of their own, so that they never mix with full ones.
        self.label = (args.study + (f"-f{args.frames}" if args.frames else "")
                      + (f"+{method}" if method else ""))
        self.folder = Path(args.results) / self.label
        self.records = self.folder / "records"
        self.manifest = self.folder / "MANIFEST"
        self.plugins: list[str] = []
        self.trials = self.list_trials(args.plugin)
        self.options = self.size + (["--serial"] if args.serial else []) + self.plugin_options()

    def list_trials(self, plugins: list[str]) -> list[str]:
        """Ids of all trials, asked of the program.

        Trials that need no plugin know of none: a new build of one leaves their records valid.
        """
        command = [self.program, "trials", self.name, *self.size, *self.plugin_options()]
        listing = subprocess.run(command, capture_output=True, text=True, check=False)
        if listing.returncode == 0:
            return listing.stdout.split()
        if plugins:
            self.plugins = plugins
            return self.list_trials([])
        sys.stderr.write(listing.stderr)  # the program has said why
        sys.exit(listing.returncode)

    def plugin_options(self) -> list[str]:
        return [word for file in self.plugins for word in ("--plugin", file)]

    def methods(self) -> set[str]:
        """Names of the methods and variants, from ids SCENARIO.METHOD. ..."""
        return {trial.split(".")[1] for trial in self.trials}

    def lock(self) -> int:
        """Keep a second run out; trials inherit the lock, so orphans of this machine count too.

        A file that is open for writing: on NFS nothing else can be locked.
        """
        self.folder.mkdir(parents=True, exist_ok=True)
        handle = os.open(self.folder / "lock", os.O_RDWR | os.O_CREAT, 0o666)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            sys.exit(f"study {self.label}: another run is still writing to {self.folder}")
        os.set_inheritable(handle, True)
        return handle

    def prepare(self, fresh: bool) -> None:
        """Make `records/`, without what a killed run left half-written; `fresh` empties it."""
        if fresh:
            self.manifest.unlink(missing_ok=True)
            shutil.rmtree(self.records, ignore_errors=True)
        self.records.mkdir(exist_ok=True)
        for file in self.records.iterdir():
            if file.suffix != ".json":
                file.unlink()

    def remove_records(self, trials: list[str]) -> None:
        for trial in trials:
            (self.records / f"{trial}.json").unlink(missing_ok=True)

    def good_records(self) -> set[str]:
        """Ids of the trials in `records/` that ended well.

        grep stops at the first match, and `status` stands at the top of a record: 10,000 records of
        any length take a fraction of a second.
        """
        names = (entry.name for entry in os.scandir(self.records) if entry.name.endswith(".json"))
        found = subprocess.run(
            ["xargs", "-0", "--no-run-if-empty", "grep", "-l", "-m1", '"status": *"ok"', "--"],
            input="\0".join(names), cwd=self.records, stdout=subprocess.PIPE, text=True, check=False)
        return {name.removesuffix(".json") for name in found.stdout.splitlines()}

    def key(self) -> str:
        """Hash of all that decides the results: program, plugins, study, scenarios it names."""
        root = HERE.parents[1]
        files = [Path(self.program), *map(Path, self.plugins)]
        study = HERE.parent / "studies" / f"{self.name}.toml"
        if study.exists():
            words = set(re.findall(r"\w+", study.read_text(encoding="utf-8")))
            scenarios = sorted((root / "datasets" / "scenarios").glob("*.toml"))
            files += [study] + [file for file in scenarios if file.stem in words]
        digest = hashlib.sha256()
        for file in files:
            digest.update(hashlib.sha256(file.read_bytes()).digest())
        return digest.hexdigest()

    def made_by(self) -> dict[str, str]:
        """Content of MANIFEST; empty if there is none."""
        return read_manifest(self.manifest)

    def write_manifest(self, key: str) -> None:
        git = subprocess.run(["git", "-C", HERE, "describe", "--always", "--dirty"],
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        self._write({"key": key, "commit": git.stdout.strip() or "unknown"})

    def write_pace(self, cpu_s_per_trial: float) -> None:
        """Note how long a trial takes, for the next estimate."""
        self._write(self.made_by() | {"cpu_s_per_trial": f"{cpu_s_per_trial:.3f}"})

    def _write(self, content: dict[str, str]) -> None:
        self.manifest.write_text("".join(f"{name} {value}\n" for name, value in content.items()))

    def command(self, trial: str) -> str:
        """The command line that repeats one trial."""
        return shlex.join([self.program, "trial", self.name, trial, *self.options,
                           "-o", str(self.records / f"{trial}.json")])

    def error(self, trial: str) -> str:
        """Why a trial failed, from its record."""
        try:
            text = (self.records / f"{trial}.json").read_text(encoding="utf-8")
        except FileNotFoundError:
            return "no record"
        match = re.search(r'"error": *"((?:[^"\\]|\\.)*)"', text)
        return match.group(1) if match else "the record is broken"


def read_manifest(file: Path) -> dict[str, str]:
    """Name -> value; empty if there is no such file."""
    if not file.exists():
        return {}
    return dict(line.split(" ", 1) for line in file.read_text(encoding="utf-8").splitlines())
