"""The speed targets and whether they are met, and every median time.

Reads   DIR/bench.json
Writes  DIR/bench.txt
Prints  the same

Example: /usr/bin/python3 -m analysis.tables.bench_table --results results
"""

from __future__ import annotations

import sys
from typing import NamedTuple, Sequence

from analysis.data.bench import MANY_RAYS, Bench, Case, bound, ldm, load_bench, threads_text
from analysis.data.bench_command_line import parser
from analysis.data.command_line import run
from analysis.data.output import write_text
from analysis.tables.text_table import aligned, number

SMALL, LARGE = (32, 200_000), (128, 1_000_000)
"""Edge and particles of the paper's map, and of a large one."""


class Target(NamedTuple):
    """`measured` [ms] over `against` [ms], or `measured` alone, is held against the limit."""

    text: str
    limit: float
    at_least: bool = False
    measured: Case | str = ""
    """A case, or the key of a number in the document's "memory"."""
    against: Case | None = None
    unit: str = "times"

    def met(self, value: float) -> bool:
        return value >= self.limit if self.at_least else value <= self.limit


def bound_targets() -> list[Target]:
    """Our frame as a multiple of the memory bound, once for each state of the memory."""
    return [
        Target(f"{size[0]}^3, {size[1]:,} particles, {threads_text(threads)}: B3 from {state}", limit,
               measured=ldm(*size, threads=threads), against=bound(state, size[1], threads))
        for size, threads, limit in ((SMALL, 1, 2.5), (SMALL, 2, 4), (LARGE, 1, 6), (LARGE, 2, 6.5))
        for state in ("memory", "cache")
    ]


def baseline_targets() -> list[Target]:
    """Ours against plain code and against OctoMap."""
    targets = [Target("plain reference over ours, 32^3, 200,000 particles", 25, at_least=True,
                      measured=Case("plain_ldm", *SMALL), against=ldm(*SMALL))]
    for edge, least, most in ((32, 15, 0.5), (128, 30, 4.5)):
        buffer = Case("circular_buffer", edge)
        targets += [
            Target(f"liboctomap over circular_buffer, {edge}^3", least, at_least=True,
                   measured=Case("liboctomap", edge), against=buffer),
            Target(f"circular_buffer, {edge}^3", most, measured=buffer, unit="ms"),
        ]
    return targets


def growth_targets() -> list[Target]:
    """More voxels around the same flight, and a second thread: our own frame over our own."""
    few = SMALL[1]
    larger = [Target(f"{edge}^3 over 32^3, {few:,} particles, 1 thread", limit, measured=ldm(edge, few),
                     against=ldm(*SMALL)) for edge, limit in ((64, 2), (128, 5), (160, 9))]
    threads = [Target(f"{size[0]}^3, {size[1]:,} particles: 1 thread over 2", least, at_least=True,
                      measured=ldm(*size), against=ldm(*size, threads=2))
               for size, least in ((SMALL, 1.2), (LARGE, 1.25))]
    return larger + threads


def targets() -> list[Target]:
    """All, in the order of the table."""
    return [
        *bound_targets(),
        *growth_targets(),
        *baseline_targets(),
        Target("64x2048 rays over 16x1024, 32^3, 200,000 particles", 1.5,
               measured=ldm(*SMALL, rays=MANY_RAYS), against=ldm(*SMALL)),
        Target("memory beside the particles, 128^3", 24, unit="bytes a voxel",
               measured="bytes_beside_particles_per_voxel"),
        Target("allocations in the steady state", 0, unit="blocks", measured="blocks_in_steady_state"),
        Target("simulated scan, 20 obstacles", 0.5, measured=Case("simulate"), unit="ms"),
    ]


def target_row(target: Target, bench: Bench) -> list[str]:
    """The cells of one line; dashes where something was not measured."""
    sign = ">=" if target.at_least else "<="
    wanted = f"{sign} {target.limit:g} {target.unit}"
    if isinstance(target.measured, str):
        value = bench.document["memory"][target.measured]
        return [target.text, "", "", number(value, 1), wanted, _verdict(target, value)]
    measured = bench.median_ms.get(target.measured)
    against = bench.median_ms.get(target.against) if target.against else None
    value = measured
    if target.against:
        value = measured / against if measured and against else None
    against_text = number(against, 3) if target.against else ""
    return [target.text, number(measured, 3), against_text, number(value, 2), wanted,
            _verdict(target, value)]


def _verdict(target: Target, value: float | None) -> str:
    if value is None:
        return "not measured"
    return "met" if target.met(value) else "NOT MET"


def table_text(bench: Bench) -> str:
    """The whole of bench.txt."""
    head = ["target", "time (ms)", "against (ms)", "value", "wanted", ""]
    rows = [target_row(target, bench) for target in targets()]
    times = [[str(case), number(ms, 3)] for case, ms in bench.median_ms.items()]
    kernels = [
        [kernel["name"], number(kernel["cpu_ms"], 4), number(1e6 * kernel["cpu_ms"] / kernel["items"], 2)]
        for kernel in bench.document["kernels"]
    ]
    return "\n".join([
        f"Speed: {bench.source()}.",
        "Medians: CPU time of one thread, wall time of more. B3: docs/benchmarks.md.\n",
        aligned(head, rows),
        aligned(["whole frame", "time (ms)"], times),
        aligned(["kernel", "time (ms)", "an item (ns)"], kernels),
    ])


def main(argv: Sequence[str] | None = None) -> None:
    """Make the table."""
    args = parser(__doc__).parse_args(argv)
    text = table_text(load_bench(args.results))
    write_text(args.results / "bench.txt", text)
    print(text, end="")


if __name__ == "__main__":
    sys.exit(run(main))
