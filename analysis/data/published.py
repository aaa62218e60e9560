"""The paper's numbers, read from published.toml."""

from __future__ import annotations

import tomllib
from functools import lru_cache
from pathlib import Path

FILE = Path(__file__).with_name("published.toml")

PAPER_NAMES = {
    "ldm": "Proposed",
    "circular_buffer": "[11]",
    "circular_buffer_pf_eq17": "[11] with PF",
    "circular_buffer_pf_free": "[11] with PF",
}
"""Our method -> the paper's name of it."""
PF_READINGS = {"circular_buffer_pf_eq17": "with Eq. 17", "circular_buffer_pf_free": "without Eq. 17"}
"""What "[11] with PF" may mean: the paper does not say whether its particles take their cluster's velocity."""


@lru_cache(maxsize=1)
def published() -> dict:
    """The whole file as nested dicts."""
    with FILE.open("rb") as stream:
        return tomllib.load(stream)


def paper_name(method: str) -> str:
    """The paper's name, with the reading where two methods answer to it."""
    name = PAPER_NAMES[method]
    return f"{name} ({PF_READINGS[method]})" if method in PF_READINGS else name


def display_name(method: str) -> str:
    """The paper's name with ours in brackets; ours alone where the paper has none."""
    return f"{PAPER_NAMES[method]} ({method})" if method in PAPER_NAMES else method
