"""The studies that the report rests on: which exist, and the command that makes each."""

from __future__ import annotations

import hashlib
from pathlib import Path

from analysis.data.bench import Bench, bench_file, load_bench
from analysis.data.records import Study, load_study

SWEEPS = (
    "particles",
    "process_noise",
    "survival",
    "resolution",
    "map_size",
    "sensor_noise",
    "channels",
    "obstacle_speed",
)
"""Studies that the report shows as figures, in its order."""

STUDIES = ("table1", "outdoor", "avoidance", "objects", "calibration", "timing", "ablation", *SWEEPS)
WORLDS, FLIGHT = "worlds", "flight"
"""Not studies: the recorded worlds of Figure 5, and those of Figure 11 with the pictures of Figures 12
and 13."""
RECORDINGS = (WORLDS, FLIGHT)
BENCH = "bench"
"""Not a study either: bench.json, the speeds."""

_COMMANDS = {"table1": "make reproduce", "timing": "make timing", "avoidance": "make avoidance",
             "objects": "make objects", BENCH: "make bench"}
_COMMANDS |= {name: "make figures" for name in RECORDINGS}


def command(name: str) -> str:
    """The command that makes a study."""
    return _COMMANDS.get(name, f"make study STUDY={name}")


class Evidence:
    """The results of one folder; a study is read when it is first asked for.

    Of a study that is there in shortened trials alone, STUDY-fN, the longest are taken.
    """

    def __init__(self, results: Path) -> None:
        """`results` holds STUDY/records/*.json."""
        self.results = results
        self._studies: dict[str, Study] = {}

    def folder(self, name: str) -> Path | None:
        """The folder of a study's results; None if there are none."""
        pattern = "*.truth.csv" if name in RECORDINGS else "records/*.json"
        shortened = [path for path in self.results.glob(f"{name}-f*") if _frames(path)]
        candidates = [self.results / name, *sorted(shortened, key=_frames, reverse=True)]
        return next((path for path in candidates if any(path.glob(pattern))), None)

    def exists(self, name: str) -> bool:
        """True if there is something of this study."""
        return self.folder(name) is not None

    def missing(self) -> list[str]:
        """Names of what the report lacks."""
        missing = [name for name in (*STUDIES, *RECORDINGS) if not self.exists(name)]
        return missing + ([] if self.bench() else [BENCH])

    def bench(self) -> Bench | None:
        """The speeds; None if they are missing.

        Raises
        ------
        InputError
            If the file is broken.
        """
        return load_bench(self.results) if bench_file(self.results).exists() else None

    def study(self, name: str) -> Study | None:
        """The study; None if it is missing.

        Raises
        ------
        InputError
            If its records cannot be used together.
        """
        if name not in self._studies:
            folder = self.folder(name)
            if folder is None:
                return None
            self._studies[name] = load_study(self.results, folder.name)
        return self._studies[name]

    def digests(self) -> dict[str, str]:
        """Hash of the files of everything that exists: it changes whenever a record does."""
        folders = {name: self.folder(name) for name in (*STUDIES, *RECORDINGS)}
        digests = {name: _digest(folder) for name, folder in folders.items() if folder}
        file = bench_file(self.results)
        return digests | ({BENCH: hashlib.sha256(file.read_bytes()).hexdigest()} if file.exists() else {})


def _frames(folder: Path) -> int:
    """The N of STUDY-fN; 0 if it has none."""
    number = folder.name.rpartition("-f")[2]
    return int(number) if number.isdecimal() else 0


def _digest(folder: Path) -> str:
    files = sorted(file for kind in ("records/*.json", "*.csv", "*.png") for file in folder.glob(kind))
    total = hashlib.sha256(folder.name.encode())
    for file in files:
        total.update(file.name.encode() + hashlib.sha256(file.read_bytes()).digest())
    return total.hexdigest()
