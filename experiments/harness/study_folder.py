"""A study's folder of results: which trials it has, which ended well, what made them.

    records/ID.json   one for each finished trial, good or failed, and its series (RECORD.md)
    MANIFEST          what made the records, and how long they took
    lock              held by whoever runs the study
    slurm/            shares and logs of a run over Slurm
"""

import argparse
import fcntl
import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pace
import program
import records
from trial_pool import Work

HERE = Path(__file__).resolve().parent
BAD_INPUT = 2
MANIFEST_NAMES = {"key", "commit", "file", "file_hash", "cpu_s_per_trial"}


class Study:
    """A study and its folder; with `method`, of that method instead of the study's own."""

    def __init__(self, args: argparse.Namespace, method: str | None = None):
        self._program = args.program
        self._limit_s = args.trial_seconds
        size = ["--seeds", str(args.seeds)] if args.seeds else []
        size += ["--frames", str(args.frames)] if args.frames else []
        size += ["--method", method] if method else []
        self._asked = args.study
        self._plugins, listing = self._list_trials(args.plugin, size)
        self._options = size + (["--serial"] if args.serial else [])
        self.trials = [trial["id"] for trial in listing["trials"]]
        self.methods: dict[str, str] = listing["methods"]
        self._frames: int = listing["frames"]
        self._file: str = listing["file"]
        self._files: dict[str, str] = listing["files"]
        # Shortened runs have a folder of their own, so that they never mix with full ones.
        self.label = (listing["study"] + (f"-f{args.frames}" if args.frames else "")
                      + (f"+{method}" if method else ""))
        self.folder = Path(args.results) / self.label
        self.records = self.folder / "records"
        self.manifest = self.folder / "MANIFEST"

    def _list_trials(self, plugins: list[str], size: list[str]) -> tuple[list[str], dict]:
        """The plugins that the trials need, and what the program says of them.

        Trials that need no plugin know of none: a new build of one leaves their records valid.
        """
        if plugins:
            listing, _ = program.ask([*program.command(self._program), "trials", self._asked, *size])
            if listing:
                return [], listing
        return plugins, program.answer([*program.command(self._program, plugins), "trials", self._asked, *size])

    def work(self) -> Work:
        """What it takes to run its trials."""
        return Work(command=[*program.command(self._program, self._plugins), "trial", self._asked],
                    options=self._options, records=str(self.records), files=self._files,
                    limit_s=self._limit_s or self._usual_limit_s())

    def _usual_limit_s(self) -> float:
        return pace.limit_s(list(self.methods.values()), self._frames, measured_cpu_s(self.made_by()))

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
        return handle

    def refuse_namesake(self) -> None:
        """Stop if the folder holds the results of another file of the same name."""
        made_by = self.made_by()
        file = made_by.get("file", self._file)
        if file != self._file and made_by.get("file_hash") != self._files[self._file]:
            print(f"study {self.label}: {self.folder} holds the results of {file}, and {self._file} is another "
                  "study of that name: rename one of them, or give another RESULTS=folder", file=sys.stderr)
            sys.exit(BAD_INPUT)

    def prepare(self, fresh: bool) -> None:
        """Make `records/`, without what a killed run left half-written; `fresh` empties it."""
        if fresh:
            self.manifest.unlink(missing_ok=True)
            shutil.rmtree(self.records, ignore_errors=True)
        self.records.mkdir(exist_ok=True)
        records.remove_unfinished(self.records)

    def found(self) -> dict[str, records.Record]:
        """The records of those of its trials that have one."""
        return records.read_all(self.records, self.trials)

    def other_files(self, found: dict[str, records.Record]) -> dict[str, str]:
        """Trials made from other files than the study's -> the first such file."""
        differing = {trial: record.other_files(self._files) for trial, record in found.items()}
        return {trial: files[0] for trial, files in differing.items() if files}

    def remove_records(self, trials: list[str]) -> None:
        for trial in trials:
            records.remove(self.records, trial)

    def key(self) -> str:
        """Hash of all that decides the results: program, plugins, study, scenarios."""
        digest = hashlib.sha256()
        for file in (self._program, *self._plugins):
            digest.update(hashlib.sha256(Path(file).read_bytes()).digest())
        digest.update(repr(sorted(self._files.items())).encode())
        return digest.hexdigest()

    def made_by(self) -> dict[str, str]:
        """Content of MANIFEST; empty if there is none."""
        return read_manifest(self.manifest)

    def write_manifest(self, key: str) -> None:
        git = subprocess.run(["git", "-C", HERE, "describe", "--always", "--dirty"],
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        self._write({"key": key, "commit": git.stdout.strip() or "unknown", "file": self._file,
                     "file_hash": self._files[self._file]})

    def write_pace(self, cpu_s_per_trial: float) -> None:
        """Note how long a trial takes, for the next estimate."""
        self._write(self.made_by() | {"cpu_s_per_trial": f"{cpu_s_per_trial:.3f}"})

    def _write(self, content: dict[str, str]) -> None:
        text = "".join(f"{name} {value}\n" for name, value in content.items())
        unfinished = self.manifest.with_suffix(".part")
        try:
            unfinished.write_text(text, encoding="utf-8")
            unfinished.replace(self.manifest)
        except OSError as error:
            raise OSError(error.errno, error.strerror, str(self.manifest)) from error


def read_manifest(file: Path) -> dict[str, str]:
    """Name -> value; empty if there is no such file. Ends the program where it is damaged."""
    if not file.exists():
        return {}
    try:
        content = dict(line.split(" ", 1) for line in file.read_text(encoding="utf-8").splitlines())
        if not content.keys() <= MANIFEST_NAMES:
            raise ValueError
        float(content.get("cpu_s_per_trial", 0))
    except ValueError:
        sys.exit(f"{file}: not as a study writes it; without the file its results count as stale")
    return content


def measured_cpu_s(manifest: dict[str, str]) -> float | None:
    """Processor time of a trial, from the last run that left it."""
    return float(manifest["cpu_s_per_trial"]) if "cpu_s_per_trial" in manifest else None
