"""The claims of Sec. 4.2.2, on the flight outdoors, held against its simulated counterpart."""

from __future__ import annotations

from dataclasses import replace

from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.scores import SCORES
from analysis.report import latex
from analysis.report.claim_rows import Row, open_row, share_row
from analysis.report.comparisons import NO, YES, compare
from analysis.report.evidence import Evidence
from analysis.tables.outdoor_table import FOLLOWING, SCENARIO, Measure, means, measures
from analysis.tables.text_table import latex_tabular, latex_text

METHOD, WITHOUT_PREDICTION = "ldm", "no_prediction"
WHERE = r"Table~\ref{tab:outdoor}"


def outdoor_rows(evidence: Evidence) -> list[Row]:
    """Static error, the hidden person's cluster and its cause, and the direction in both scenarios."""
    entries = published()["outdoor"]
    study = evidence.study("outdoor")
    bound = entries["static"]["largest_error_mps"]
    static = entries["static"] | {"claim": f"up to {bound} m/s"}
    occlusion = entries["occlusion"]
    direction = entries["direction"] | {"claim": "right"}
    standing = _share_row(study, "error of the standing person in every direction", static,
                          "static_share", f"of the frames within {bound} m/s")  # fmt: skip
    return [
        replace(standing, ours=standing.ours + _largest(study)),
        _share_row(study, "a hidden person keeps its cluster", occlusion,
                   "hidden_matched", "of the frames in hiding have one"),
        _share_row(study, "a hidden person keeps its identity", occlusion,
                   "kept", "of the occlusions have the same track before and after"),
        _cause_row(study, occlusion),
        *(_share_row(study, f"direction of the estimated velocity, {scenario}", direction,
                     name, "of the frames right")
          for name, scenario in (("direction", SCENARIO), ("direction_following", FOLLOWING))),
    ]  # fmt: skip


def _largest(study: Study | None) -> tuple[str, ...]:
    if study is None:
        return ()
    measure = measures()["static_largest"]
    return (f"largest {latex.interval(means(study, measure)[METHOD], measure.decimals)} m/s",)


def _share_row(study: Study | None, what: str, entry: dict, name: str, line: str) -> Row:
    statement = f"Outdoor: {what}"
    if study is None:
        return _open(statement, entry, latex.missing("outdoor"))
    measure = measures()[name]
    shares = measure.values(study, measure.scenario, METHOD)
    if shares.empty:
        return _open(statement, entry, "no such frame in trials this short")
    return share_row(statement, entry, shares, line, WHERE)


def _cause_row(study: Study | None, entry: dict) -> Row:
    """A cluster that is lost is found again as another track: prediction must make fewer."""
    statement = f"Outdoor: prediction is the cause ({entry['claim']})"
    if study is None:
        return _open(statement, entry, latex.missing("outdoor"))
    score = SCORES["tracks_per_stay"]
    found = compare(study, SCENARIO, score.name, METHOD, WITHOUT_PREDICTION)
    if not found.difference.n:
        return _open(statement, entry, f"no trial of {latex.code(WITHOUT_PREDICTION)}")
    line = "tracks of a person: with $-$ without " + latex.interval(
        found.difference, score.difference_decimals, sign=True
    )
    verdict = YES if found.difference.high < 0 else NO
    return Row(statement, latex.plain(entry["place"]), "in words", (line,), verdict, WHERE, found.p)


def _open(statement: str, entry: dict, reason: str) -> Row:
    return open_row(statement, entry["place"], entry["claim"], reason, WHERE)


def outdoor_table(evidence: Evidence, caption: str) -> str:
    """Every measure, the paper's claim and ours for each method."""
    study = evidence.study("outdoor")
    if study is None:
        return latex.table(latex.missing("outdoor"), caption, "tab:outdoor")
    head = " & ".join(["", "paper", *(latex.code(method) for method in study.methods)]) + r" \\"
    rows = [_table_row(study, measure) for measure in measures().values()]
    body = latex_tabular("ll" + "r" * len(study.methods), [head], rows)
    return latex.table(r"\fitted{" + body.strip() + "}", caption, "tab:outdoor")


def _table_row(study: Study, measure: Measure) -> list[str]:
    found = means(study, measure)
    cells = [latex.interval(found[method], measure.decimals) for method in study.methods]
    return [latex_text(measure.label), latex_text(measure.paper), *cells]
