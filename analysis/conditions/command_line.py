"""The command line that the scripts of this folder share."""

import argparse
from pathlib import Path


def argument_parser(text: str | None) -> argparse.ArgumentParser:
    """Explains the script by `text`, as its docstring has it; knows the folder of all results."""
    parser = argparse.ArgumentParser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--results", type=Path, default=Path("results"), metavar="DIR")
    return parser
