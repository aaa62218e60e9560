"""Write what an analysis made: whole files, the same bytes for the same records."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pandas as pd


def write_bytes(file: Path, content: bytes) -> None:
    """Write `file`, making its folder; whole or not at all.

    Raises
    ------
    OSError
        Naming `file`.
    """
    unfinished = file.with_name(f".{file.name}.part")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        unfinished.write_bytes(content)
        unfinished.replace(file)
    except OSError as error:
        with suppress(OSError):
            unfinished.unlink()
        raise OSError(error.errno, error.strerror, str(file)) from error


def write_text(file: Path, text: str) -> None:
    """Write `file`, making its folder."""
    write_bytes(file, text.encode())


def write_csv(file: Path, table: pd.DataFrame) -> None:
    """Write `table` with nine significant digits and no index."""
    write_text(file, table.to_csv(index=False, float_format="%.9g"))
