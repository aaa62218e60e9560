"""Where the recorded worlds and pictures of a figure come from."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Sequence

NAME = "recorded.toml"
"""Beside the files: `seed`, and `program` as `ldm --version` prints it; `make figures` writes it."""


def source(files: Sequence[Path]) -> str:
    """`Source: FILES` of one folder, with seed and commit where NAME tells of them."""
    words = [", ".join(file.name for file in files)]
    note = files[0].parent / NAME
    if note.exists():
        content = tomllib.loads(note.read_text(encoding="utf-8"))
        commit = re.search(r"commit (\w{12})\w*(, changed)?", content["program"])
        words.append(f"seed {content['seed']}")
        words += [f"commit {commit[1]}{commit[2] or ''}"] if commit else []
    return f"Source: {', '.join(words)}."
