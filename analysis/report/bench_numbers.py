"""Numbers of `make bench` that the text of the report names: the frame against the memory bound."""

from __future__ import annotations

from analysis.data.bench import Case, bound, ldm
from analysis.report import latex
from analysis.report.evidence import BENCH, Evidence
from analysis.tables.bench_table import LARGE, SMALL

PARTICLE_BYTES = 16
"""Of the bound and of ldm/particle.h."""

KEYS = ("frame", "bound", "bound.cache", "over-bound", "frame.two", "large", "large.over-bound",
        "large.edge", "large.particles", "plain", "buffer", "octomap", "cpu", "bytes",
        "particle-bytes")  # fmt: skip


def bench_numbers(evidence: Evidence) -> dict[str, str]:
    """Key -> LaTeX text; every key says so if the benchmark is missing."""
    bench = evidence.bench()
    if bench is None:
        return {f"bench.{key}": latex.missing(BENCH) for key in KEYS}
    ms = bench.median_ms.get
    frame, large = ms(ldm(*SMALL)), ms(ldm(*LARGE))
    memory = ms(bound("memory", SMALL[1], 1))
    buffer = ms(Case("circular_buffer", SMALL[0]))
    document = bench.document
    values = {
        "frame": latex.value(frame, 2),
        "bound": latex.value(memory, 2),
        "bound.cache": latex.value(ms(bound("cache", SMALL[1], 1)), 2),
        "over-bound": latex.value(_ratio(frame, memory), 1),
        "frame.two": latex.value(ms(ldm(*SMALL, threads=2)), 2),
        "large": latex.value(large, 1),
        "large.over-bound": latex.value(_ratio(large, ms(bound("memory", LARGE[1], 1))), 1),
        "large.edge": str(LARGE[0]),
        "large.particles": latex.value(LARGE[1], 0),
        "plain": latex.value(_ratio(ms(Case("plain_ldm", *SMALL)), frame), 0),
        "buffer": latex.value(buffer, 2),
        "octomap": latex.value(_ratio(ms(Case("liboctomap", SMALL[0])), buffer), 0),
        "cpu": latex.latex_text(document["machine"]["cpu"]),
        "bytes": latex.value(document["memory"]["bytes_beside_particles_per_voxel"], 1),
        "particle-bytes": str(PARTICLE_BYTES),
    }
    return {f"bench.{key}": values[key] for key in KEYS}


def _ratio(numerator: float | None, denominator: float | None) -> float | None:
    """None if a case was not timed."""
    return numerator / denominator if numerator and denominator else None
