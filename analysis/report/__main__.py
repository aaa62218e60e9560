"""Write everything of the report in paper/ that comes from results; `make paper` calls it.

Reads   DIR/STUDY/records/*.json, DIR/worlds/, DIR/flight/, and what tests/equations.py --json prints
Writes  OUTPUT/*.tex, OUTPUT/figures/, and OUTPUT/sources.json: what the rest was made from
Prints  which studies are missing, and the command that makes each

Example: /usr/bin/python3 -m analysis.report --results results --equations FILE --output DIR
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Sequence

from analysis.data.command_line import run
from analysis.data.output import write_text
from analysis.data.records import Study
from analysis.report import latex
from analysis.report.claims import ledger, ledger_table
from analysis.report.claims_outdoor import outdoor_table
from analysis.report.closed_loop import success_table
from analysis.report.equations import index_table, read_index
from analysis.report.evidence import SWEEPS, Evidence, command
from analysis.report.figures import write_figures
from analysis.report.numbers import definitions, numbers
from analysis.report.objects import goals_table
from analysis.report.open_points import points_table
from analysis.report.sensitivity import sensitivity_table
from analysis.report.sources import write_sources
from analysis.report.sweeps import ends_table
from analysis.report.time_table import stages_table
from analysis.tables import accuracy_table, velocity_table
from analysis.tables.mean_table import Means, mean_table

PARAMETER_STUDIES = ("table1", "ablation", "timing")
"""Where the LDM's own parameters are looked for, in this order."""


def write_report(evidence: Evidence, equations: Path, output: Path) -> None:
    """Write all generated files into `output`."""
    rows = ledger(evidence)
    defaults = _defaults(evidence)
    index = read_index(equations)
    found = numbers(evidence, rows, defaults)
    found |= {f"eq.{equation.number}": latex.code(equation.file) for equation in index}
    captions = _captions(evidence)
    files = {
        "numbers": definitions(found),
        "ledger": ledger_table(rows, captions["ledger"]),
        "accuracy": _tabular(evidence, accuracy_table, captions["accuracy"], "tab:accuracy"),
        "velocity": _tabular(evidence, velocity_table, captions["velocity"], "tab:velocity"),
        "avoidance": success_table(evidence, captions["avoidance"]),
        "objects": goals_table(evidence, captions["objects"]),
        "outdoor": outdoor_table(evidence, captions["outdoor"]),
        "open-points": points_table(evidence, defaults, captions["open-points"]),
        "sensitivity": sensitivity_table(evidence, captions["sensitivity"]),
        "equations": index_table(index, captions["equations"]),
        "time": stages_table(evidence, captions["time"]),
        "sweeps": ends_table(evidence, captions["sweeps"]),
    }
    for name, text in files.items():
        write_text(output / f"{name}.tex", text)
    write_figures(evidence, output)
    write_sources(evidence, output)


def _defaults(evidence: Evidence) -> dict[str, object]:
    """The LDM's own parameters, from the first study that has them."""
    for name in PARAMETER_STUDIES:
        study = evidence.study(name)
        for record in study.records if study else ():
            if record["method"] == "ldm":
                return record["parameters"]
    return {}


def _tabular(evidence: Evidence, part, caption: str, label: str) -> str:
    """A table that `make tables` also makes, of `accuracy_table` or `velocity_table`."""
    study = evidence.study("table1")
    if study is None:
        return latex.table(latex.missing("table1"), caption, label)
    means = Means(mean_table(study, part.SHOWN))
    return latex.table(r"\fitted{" + part.tabular(study, means).strip() + "}", caption, label)


def _captions(evidence: Evidence) -> dict[str, str]:
    """Captions of the tables: what a cell is, and study, seeds, frames and commit."""
    effects = "alternative $-$ LDM, paired by seed, with its interval"
    orders = (
        r"\sameorder{} the paper's order, \otherorder{} the opposite, \noorder{} the interval "
        "includes zero"
    )
    texts = {
        "ledger": ("Claims of the paper's evaluation", ("table1", "ablation", "timing", "outdoor")),
        "accuracy": ("Occupancy grid accuracy, the paper's beside ours", ("table1",)),
        "velocity": ("Velocity error, the paper's beside ours", ("table1",)),
        "outdoor": ("Claims on the flight outdoors, the paper's beside ours", ("outdoor",)),
        "avoidance": (r"Flights that reach the goal (\%), with 95\,\% Wilson intervals", ("avoidance",)),
        "objects": (r"Goals of \code{object\_ldm}, and means over seeds; $+$: it is better than this method, $-$: "
                    "worse, beyond chance", ("objects",)),
        "open-points": (f"Open points and their effect: {effects}",
                        ("ablation", "process_noise", "survival")),
        "sensitivity": (f"Orders under other circumstances: {orders}",
                        ("table1", "ablation", "obstacle_speed")),
        "time": ("Computation time of one update", ("timing",)),
        "sweeps": ("Ends of each sweep: LDM at the last point $-$ LDM at the first, paired by seed",
                   SWEEPS),
    }  # fmt: skip
    found = {name: f"{text}. {_sources(evidence, names)}" for name, (text, names) in texts.items()}
    return found | {"equations": "Where each equation is declared, and the test that holds it to a "
                                 "case worked by hand."}  # fmt: skip


def _sources(evidence: Evidence, names: tuple[str, ...]) -> str:
    """`Source: ...` for those that exist."""
    studies = [study for study in map(evidence.study, names) if study is not None]
    if not studies:
        return ""
    text = "; ".join(_source(study) for study in studies)
    return latex.breakable(latex.plain(f"Source: {text}."))


def _source(study: Study) -> str:
    return study.source() + (", incomplete" if study.notes else "")


def report_missing(evidence: Evidence) -> None:
    """Print what the report lacks and how to make it."""
    missing = evidence.missing()
    if missing:
        print("The report still misses:")
        width = max(map(len, missing))
        print(*(f"  {name:<{width}}  {command(name)}" for name in missing), sep="\n")


def main(argv: Sequence[str] | None = None) -> None:
    """Write the generated files of one folder of results."""
    parser = argparse.ArgumentParser(
        prog="report", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--results", type=Path, default=Path("results"), metavar="DIR")
    parser.add_argument("--equations", type=Path, required=True, metavar="FILE")
    parser.add_argument("--output", type=Path, required=True, metavar="DIR")
    args = parser.parse_args(argv)
    evidence = Evidence(args.results)
    write_report(evidence, args.equations, args.output)
    report_missing(evidence)


if __name__ == "__main__":
    sys.exit(run(main))
