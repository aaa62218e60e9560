"""The command line of the scripts that read bench.json."""

from __future__ import annotations

import argparse
from pathlib import Path


def parser(doc: str) -> argparse.ArgumentParser:
    """A parser with --results; `doc` is the script's docstring."""
    made = argparse.ArgumentParser(
        description=doc, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    made.add_argument("--results", type=Path, default=Path("results"), metavar="DIR",
                      help="folder that holds bench.json (default: results)")
    return made
