"""Run the missing trials of one study; `make study` calls it and documents its options.

Make runs the trials (trials.mk); this script says which, keeps results of different programs apart,
shows progress, and tells what failed. A method that the study lacks (--methods) has its trials in a
folder of its own, STUDY+METHOD: held against the study's, they leave its records alone.
Exit codes: 0 all trials good, 1 some failed or the records are stale, 2 bad input, 130 interrupted.
"""

import argparse
import fcntl
import hashlib
import os
import re
import selectors
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from progress import Progress

HERE = Path(__file__).resolve().parent
LISTED_FAILURES = 20
INTERRUPTED = 130  # exit code, as of a shell


class Interrupted(Exception):
    """Ctrl-C, or a polite request to end."""


class Study:
    """A study's folder of results: `records/ID.json`, and MANIFEST, which says what made them.

    With `method`, of that method instead of the study's own.
    """

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

    def remove_unfinished(self) -> None:
        """Delete what a killed run left half-written; a finished record ends in `.json`."""
        for file in self.records.iterdir():
            if file.suffix != ".json":
                file.unlink()

    def key(self) -> str:
        """Hash of all that decides the results: program, plugins, study, scenarios it names."""
        root = HERE.parent
        files = [Path(self.program), *map(Path, self.plugins)]
        study = HERE / "studies" / f"{self.name}.toml"
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
        if not self.manifest.exists():
            return {}
        return dict(line.split(" ", 1) for line in self.manifest.read_text().splitlines())

    def write_manifest(self, key: str) -> None:
        git = subprocess.run(["git", "-C", HERE, "describe", "--always", "--dirty"],
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=False)
        self.manifest.write_text(f"key {key}\ncommit {git.stdout.strip() or 'unknown'}\n")

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


def parse_arguments() -> argparse.Namespace:
    def positive(text: str) -> int:
        if not re.fullmatch(r"[1-9][0-9]{0,8}", text):
            raise argparse.ArgumentTypeError(f"{text!r}: a whole number of at least 1 is needed")
        return int(text)

    parser = argparse.ArgumentParser(prog="study", description=__doc__)
    parser.add_argument("study", help="name of the study, as `make studies` lists it")
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--results", default="results", help="folder of all results")
    parser.add_argument("--seeds", type=positive, help="replicates, instead of the study's number")
    parser.add_argument("--frames", type=positive, help="frames, instead of the scenarios' number")
    parser.add_argument("--jobs", type=positive, default=os.cpu_count(), help="trials at a time")
    parser.add_argument("--serial", action="store_true",
                        help="one trial at a time, and say in the records that timings are valid")
    parser.add_argument("--fresh", action="store_true",
                        help="run all trials again; with --methods, those that are stale")
    parser.add_argument("--methods", type=lambda text: text.replace(",", " ").split(), default=[],
                        metavar="NAMES", help="methods to run beside those of the study")
    parser.add_argument("--plugin", action="append", default=[], metavar="FILE",
                        help="shared object with more methods; may be repeated")
    args = parser.parse_args()
    if args.serial:
        args.jobs = 1
    return args


def lock(study: Study) -> int:
    """Keep a second run of the same study out; trials inherit the lock, so orphans count too."""
    handle = os.open(study.folder, os.O_RDONLY)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit(f"study {study.label}: another run is still writing to {study.folder}")
    os.set_inheritable(handle, True)
    return handle


def check_manifest(study: Study, good: set[str], missing: int) -> None:
    """Write the manifest of a study that begins; refuse to mix records of different programs."""
    key = study.key()
    if not good:
        study.write_manifest(key)
        return
    made_by = study.made_by()
    if made_by.get("key") == key:
        return
    origin = f"commit {made_by['commit']}" if made_by else "an unknown program"
    stale = (f"study {study.label}: {len(good)} results are stale (made by {origin}; program, study "
             "or scenarios have changed since)")
    if missing:
        sys.exit(f"{stale} and {missing} are missing: FRESH=1 runs all again; nothing was run")
    print(f"{stale}, using them; FRESH=1 runs them again", file=sys.stderr)


def start_make(study: Study, todo: Path, jobs: int, lock_handle: int) -> subprocess.Popen:
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}
    return subprocess.Popen(
        ["make", "-f", str(HERE / "trials.mk"), "--keep-going", f"--jobs={jobs}",
         f"PROGRAM={study.program}", f"STUDY={study.name}", f"OPTIONS={' '.join(study.options)}",
         f"RECORDS={study.records}", f"TODO={todo}"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment, pass_fds=[lock_handle],
        # A group of its own: the whole tree can be interrupted at once, whoever asked for it.
        process_group=0)


def follow(make: subprocess.Popen, progress: Progress) -> None:
    """Show progress until Make ends; what Make itself complains of goes to stderr at the end."""
    complaints = b""
    with selectors.DefaultSelector() as selector:
        selector.register(make.stdout, selectors.EVENT_READ)
        selector.register(make.stderr, selectors.EVENT_READ)
        while selector.get_map():
            for ready, _ in selector.select(timeout=Progress.BAR_INTERVAL_S):
                data = os.read(ready.fd, 65536)
                if not data:
                    selector.unregister(ready.fileobj)
                elif ready.fileobj is make.stderr:
                    complaints += data
                else:
                    # A line is shorter than a pipe's atomic write, so none is ever split.
                    for line in data.splitlines():
                        progress.count(failed=line == b"failed")
            progress.show()
    progress.finish()
    make.wait()
    sys.stderr.write(complaints.decode(errors="replace"))


def run(study: Study, todo: list[str], jobs: int, lock_handle: int) -> None:
    """Run the trials `todo`. @raises Interrupted after everything running has been ended."""
    for trial in todo:  # failed before: each is tried again
        (study.records / f"{trial}.json").unlink(missing_ok=True)

    signals = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)

    def interrupt(*_):
        for number in signals:
            signal.signal(number, signal.SIG_IGN)  # once is enough
        raise Interrupted

    for number in signals:
        signal.signal(number, interrupt)
    with tempfile.NamedTemporaryFile("w", suffix=".todo") as listing:
        listing.write("\n".join(todo))
        listing.flush()
        make = start_make(study, Path(listing.name), jobs, lock_handle)
        try:
            follow(make, Progress(f"study {study.label}", len(todo)))
        except Interrupted:
            os.killpg(make.pid, signal.SIGINT)
            make.communicate()
            raise


def report(study: Study, trials: list[str]) -> int:
    """Print the outcome; the exit code."""
    good = study.good_records()
    failed = [trial for trial in trials if trial not in good]
    print(f"study {study.label}: {len(trials) - len(failed)} of {len(trials)} trials good, "
          f"records in {study.records}")
    for trial in failed[:LISTED_FAILURES]:
        print(f"FAILED {trial}: {study.error(trial)}\n  {study.command(trial)}", file=sys.stderr)
    if len(failed) > LISTED_FAILURES:
        print(f"... and {len(failed) - LISTED_FAILURES} more", file=sys.stderr)
    if failed:
        print(f"study {study.label}: {len(failed)} of {len(trials)} trials failed; "
              "the same command tries them again", file=sys.stderr)
    return 1 if failed else 0


def complete(study: Study, jobs: int, fresh: bool) -> int:
    """Run what is missing of one study; the exit code."""
    study.folder.mkdir(parents=True, exist_ok=True)
    lock_handle = lock(study)
    if fresh:
        study.manifest.unlink(missing_ok=True)
        shutil.rmtree(study.records, ignore_errors=True)
    study.records.mkdir(exist_ok=True)
    study.remove_unfinished()
    good = study.good_records()
    todo = [trial for trial in study.trials if trial not in good]
    check_manifest(study, good, len(todo))
    if todo:
        print(f"study {study.label}: {len(study.trials)} trials, {len(todo)} to run, {jobs} at a time",
              file=sys.stderr)
        try:
            run(study, todo, jobs, lock_handle)
        except Interrupted:
            print(f"\nstudy {study.label}: stopped; the same command continues it", file=sys.stderr)
            return INTERRUPTED
    return report(study, study.trials)


def main() -> int:
    args = parse_arguments()
    studies = [Study(args)]
    studies += [Study(args, method) for method in args.methods if method not in studies[0].methods()]
    code = 0
    for study in studies:
        # Beside other methods, what is not stale is what they are held against.
        fresh = args.fresh and (not args.methods or study.made_by().get("key") != study.key())
        code = max(code, complete(study, args.jobs, fresh))
        if code == INTERRUPTED:
            break
    return code


if __name__ == "__main__":
    sys.exit(main())
