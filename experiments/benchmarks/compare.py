"""Hold another revision's speed against the working tree's; `make bench-compare REV=...` calls it.

The revision is checked out beside the working tree, into build-rev/SHA/, and its own `ldm_bench` is
built there. Both programs then run in turn, pair by pair, and each pair gives a ratio per configuration.
Exit codes: 0 compared, 1 a build or a program failed, 2 bad input.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import subprocess
import sys
from pathlib import Path

from samples import BenchError, Configuration, run_program

FOLDER = Path("build-rev")
NEEDED = "experiments/benchmarks/CMakeLists.txt"


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bench-compare", description=__doc__)
    parser.add_argument("--revision", required=True, help="anything that git takes for a commit")
    parser.add_argument("--program", type=Path, required=True, help="`ldm_bench` of the working tree")
    parser.add_argument("--frames", type=int, default=30, help="of each configuration and run")
    parser.add_argument("--pairs", type=int, default=9, help="runs of either program; at least 3")
    parser.add_argument("--only", action="append", metavar="PREFIX",
                        help="configurations whose name begins with it (default: ldm/)")
    parser.add_argument("--native", action="store_true", help="build the revision with NATIVE=ON")
    parser.add_argument("--jobs", default=str(os.cpu_count()), help="of the build")
    args = parser.parse_args()
    args.only = args.only or ["ldm/"]
    if args.pairs < 3:
        parser.error(f"--pairs {args.pairs}: allowed: at least 3")
    return args


def git(*words: str) -> subprocess.CompletedProcess:
    return subprocess.run(["git", *words], capture_output=True, text=True, check=False)


def commit_of(revision: str) -> str:
    """Its full hash.

    Raises
    ------
    BenchError
        If git knows no such commit, or it is from before the benchmarks.
    """
    found = git("rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
    if found.returncode != 0:
        raise BenchError(f"REV={revision}: no such revision here", 2)
    sha = found.stdout.strip()
    if git("cat-file", "-e", f"{sha}:{NEEDED}").returncode != 0:
        raise BenchError(f"REV={revision}: it has no {NEEDED}: allowed: revisions with benchmarks", 2)
    return sha


def build(sha: str, native: bool, jobs: str) -> Path:
    """Check the commit out, build its program; what an earlier call left is used again."""
    source = (FOLDER / sha / "source").absolute()
    binary = (FOLDER / sha).absolute() / ("build-native" if native else "build")
    if not source.is_dir():
        git("worktree", "prune")
        added = git("worktree", "add", "--detach", str(source), sha)
        if added.returncode != 0:
            raise BenchError(f"git worktree: {added.stderr.strip().splitlines()[-1]}", 1)
    environment = os.environ | {"CCACHE_BASEDIR": str(source)}
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    for command in (
        ["cmake", "-S", source, "-B", binary, "--log-level=NOTICE", "-DCMAKE_BUILD_TYPE=Release",
         f"-DNATIVE={'ON' if native else 'OFF'}", *launcher],
        ["cmake", "--build", binary, "--parallel", jobs, "--target", "ldm_bench"],
    ):
        done = subprocess.run(command, env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            log = FOLDER / sha / "log"
            log.write_text(done.stdout, encoding="utf-8")
            raise BenchError(f"{sha[:12]} does not build: see {log}", 1)
    return binary / "bin" / "ldm_bench"


def measure(theirs: Path, ours: Path, args: argparse.Namespace) -> dict[Configuration, list[float]]:
    """Ratio ours / theirs of the median times, for each pair of runs."""
    ratios: dict[Configuration, list[float]] = {}
    for pair in range(args.pairs):
        if sys.stderr.isatty():
            print(f"\rpair {pair + 1} of {args.pairs} ", end="", file=sys.stderr, flush=True)
        # Whoever comes second may find a warmer machine: the order changes from pair to pair.
        order = (theirs, ours) if pair % 2 == 0 else (ours, theirs)
        samples = {program: run_program(program, args.frames, args.only).samples for program in order}
        before, after = samples[theirs], samples[ours]
        for case in after.keys() & before.keys():
            ratio = after[case].median(case.clock) / before[case].median(case.clock)
            ratios.setdefault(case, []).append(ratio)
    if not ratios:
        raise BenchError(f"REV={args.revision}: no configuration in common", 2)
    return ratios


def interval(ratios: list[float]) -> tuple[float, float]:
    """Between the second smallest and the second largest ratio, whatever their distribution.

    The true median lies outside if at most one of n ratios falls on one side of it: for n = 9 with
    probability 2 (1 + 9) / 2^9 = 4 %.
    """
    ordered = sorted(ratios)
    return ordered[1], ordered[-2]


def table(ratios: dict[Configuration, list[float]], revision: str, pairs: int) -> str:
    lines = [f"time of the working tree / time of {revision}: median and interval of {pairs} pairs",
             f"{'configuration':36}{'ratio':>7}  interval"]
    for configuration in sorted(ratios):
        low, high = interval(ratios[configuration])
        verdict = "faster" if high < 1 else "slower" if low > 1 else ""
        middle = statistics.median(ratios[configuration])
        lines.append(f"{str(configuration):36}{middle:7.3f}  {low:.3f}..{high:.3f}  {verdict}".rstrip())
    return "\n".join(lines)


def main() -> int:
    args = parse_arguments()
    try:
        theirs = build(commit_of(args.revision), args.native, args.jobs)
        ratios = measure(theirs, args.program.absolute(), args)
    except BenchError as error:
        print(f"bench-compare: {error}", file=sys.stderr)
        return error.code
    print("\r" if sys.stderr.isatty() else "", end="", file=sys.stderr)
    print(table(ratios, args.revision, args.pairs))
    return 0


if __name__ == "__main__":
    sys.exit(main())
