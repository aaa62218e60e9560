"""Write what an analysis made: whole files, the same bytes for the same records."""

from __future__ import annotations

from pathlib import Path

import pandas as pd


def write_text(file: Path, text: str) -> None:
    """Write `file`, making its folder."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def write_csv(file: Path, table: pd.DataFrame) -> None:
    """Write `table` with nine significant digits and no index."""
    write_text(file, table.to_csv(index=False, float_format="%.9g"))
