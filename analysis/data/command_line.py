"""What every script's command line shares: --results, --study, and exit codes 0, 1, 2, 130."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path
from typing import Callable, Sequence

from analysis.data.errors import InputError
from analysis.data.records import Study, load_study


def parser(doc: str, study: str) -> argparse.ArgumentParser:
    """A parser with --results and --study; `doc` is the script's docstring, `study` the default."""
    made = argparse.ArgumentParser(
        description=doc, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    made.add_argument(
        "--results",
        type=Path,
        default=Path("results"),
        metavar="DIR",
        help="folder that holds STUDY/records/*.json (default: results)",
    )
    made.add_argument(
        "--study", default=study, metavar="NAME", help=f"folder in DIR (default: {study})"
    )
    return made


def name_list(text: str) -> list[str]:
    """Names separated by commas or spaces, as a command-line type."""
    return text.replace(",", " ").split()


def add_scores(made: argparse.ArgumentParser, default: Sequence[str], purpose: str) -> None:
    """Give a parser --scores, which are there `purpose`: to show, to compare."""
    made.add_argument(
        "--scores",
        type=name_list,
        default=list(default),
        metavar="NAMES",
        help=f"scores {purpose} (default: {', '.join(default)})",
    )


def add_method(made: argparse.ArgumentParser, default: str) -> None:
    """Give a parser --method: whose velocities the figures show."""
    made.add_argument(
        "--method",
        default=default,
        metavar="NAME",
        help=f"whose velocities to show; if NAME of --study lacks it, from NAME+METHOD (default: {default})",
    )


def study_of(args: argparse.Namespace, methods: Sequence[str] = (), swept: bool = True) -> Study:
    """The study that --results and --study name, with a sweep only if `swept`. Prints what it lacks on
    stderr: a table with gaps never goes unannounced."""
    study = load_study(args.results, args.study, methods)
    if not swept:
        study.require_no_sweep()
    for note in study.notes:
        print(f"{study.folder}: {note}", file=sys.stderr)
    return study


def run(main: Callable[[Sequence[str] | None], None], argv: Sequence[str] | None = None) -> int:
    """Exit code of `main`: 0, or with one line on stderr 2 if the input is bad, 1 if a file cannot be
    written, 130 at Ctrl-C."""
    try:
        main(argv)
        sys.stdout.flush()
    except InputError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("interrupted: the same command makes all of it anew", file=sys.stderr)
        return 130
    except BrokenPipeError:  # whoever reads the printed table has seen enough; files are written
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except OSError as error:
        print(f"error: {error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    return 0
