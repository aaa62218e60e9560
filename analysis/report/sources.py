"""What the generated files were made from, so that a table older than its records is found."""

from __future__ import annotations

import json
from pathlib import Path

from analysis.data.output import write_text
from analysis.report.evidence import Evidence, command

NAME = "sources.json"


def write_sources(evidence: Evidence, output: Path) -> None:
    """Write OUTPUT/sources.json: the folder of the results, and a digest of each study."""
    content = {"results": str(evidence.results.resolve()), "digests": evidence.digests()}
    write_text(output / NAME, json.dumps(content, indent=1, sort_keys=True) + "\n")


def stale(output: Path) -> list[str]:
    """A line for each study whose records are not those that OUTPUT was made from.

    Empty if nothing was generated, or if the results are gone.
    """
    file = output / NAME
    if not file.exists():
        return []
    content = json.loads(file.read_text(encoding="utf-8"))
    made_from, results = content["digests"], Path(content["results"])
    if not results.is_dir():
        return []
    now = Evidence(results).digests()
    return [
        f"{output}: made from other records of {name} than {results / name} holds: `make paper`; "
        f"the records: `{command(name)}`"
        for name in sorted(made_from.keys() | now.keys())
        if made_from.get(name) != now.get(name)
    ]
