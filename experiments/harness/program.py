"""What the `ldm` program says of studies and trials, asked as JSON, of this tree's data."""

import json
import subprocess
import sys
from pathlib import Path

DATA = Path(__file__).resolve().parents[2]


def command(program: str, plugins: list[str] = ()) -> list[str]:
    """Whatever build the program is of: scenarios and studies are those of this tree."""
    return [program, "--data-dir", str(DATA), *(word for file in plugins for word in ("--plugin", file))]


def ask(words: list[str]) -> tuple[dict | list | None, subprocess.CompletedProcess]:
    """The program's answer; None if it has refused. Whatever else answers ends this program."""
    done = subprocess.run([*words, "--json"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return None, done
    try:
        return json.loads(done.stdout), done
    except ValueError:
        sys.exit(f"{words[0]}: answers no JSON; LDM is to be the `ldm` program")


def answer(words: list[str]) -> dict | list:
    """The program's answer; where it refuses, its own words and exit code end this program."""
    found, done = ask(words)
    if found is None:
        sys.stderr.write(done.stderr)
        sys.exit(done.returncode if done.returncode > 0 else 1)
    return found
