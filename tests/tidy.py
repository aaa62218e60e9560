"""clang-tidy on each source that it has not passed before; `make style`.

What it passed is remembered by a hash of all that its findings depend on: the source, the headers of this
repository that it includes, .clang-tidy, the compile command, clang-tidy's version and those of the Debian
packages that hold headers. Other clones on the same machine profit. Exit code 1 if a source does not pass.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = ("ldm", "baselines", "datasets")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
# g++'s precompiled headers, which clang-tidy cannot read: it sees what the source itself includes.
PRECOMPILED = re.compile(r"-Winvalid-pch\s+-include\s+\S+")


def compile_commands(root: Path, build: Path) -> dict[Path, dict[str, str]]:
    """The entry of the compile database of each source in FOLDERS."""
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    commands = {}
    for entry in entries:
        file = Path(entry["file"])
        if any(file.is_relative_to(root / folder) for folder in FOLDERS):
            commands[file] = {**entry, "command": PRECOMPILED.sub("", entry["command"])}
    return commands


def included(root: Path, source: Path) -> list[Path]:
    """The source and all headers of the repository that it includes, directly or not."""
    found, todo = {source}, [source]
    while todo:
        for name in INCLUDE.findall(todo.pop().read_text(encoding="utf-8")):
            header = root / name
            if header.is_file() and header not in found:  # else a library's: its package is known
                found.add(header)
                todo.append(header)
    return sorted(found)


def environment(root: Path, program: str) -> bytes:
    """What all sources share: clang-tidy, its configuration, and the packages that hold headers."""
    version = subprocess.run([program, "--version"], check=True, stdout=subprocess.PIPE).stdout
    packages = subprocess.run(["dpkg-query", "--show", "*-dev", "libc6"], check=True,
                              stdout=subprocess.PIPE).stdout
    return version + packages + (root / ".clang-tidy").read_bytes()


def fingerprint(root: Path, source: Path, command: str, shared: bytes) -> str:
    words = [word.replace(str(root), "") for word in shlex.split(command) if not word.endswith("ccache")]
    digest = hashlib.sha256(shared + "\0".join(words).encode())
    for file in included(root, source):
        digest.update(str(file.relative_to(root)).encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def check(program: str, database: Path, source: Path) -> str:
    """The findings in one source; empty if there are none."""
    run = subprocess.run([program, "-quiet", "-p", database, source], stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, text=True, encoding="utf-8", errors="replace")
    return "" if run.returncode == 0 else run.stdout or run.stderr or f"{source}: exit code {run.returncode}"


def main() -> int:
    cache = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "ldm-clang-tidy"
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path, help="folder with compile_commands.json")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("--clang-tidy", default="clang-tidy-14")
    parser.add_argument("--cache", type=Path, default=cache, help="a file for each state that passed")
    options = parser.parse_args()

    commands = compile_commands(options.root, options.build)
    for source in commands:
        if not source.is_file():
            print(f"{options.build}/compile_commands.json: {source}: is no longer there: allowed: after cmake",
                  file=sys.stderr)
            return 2
    database = options.build / "clang-tidy"
    database.mkdir(exist_ok=True)
    (database / "compile_commands.json").write_text(json.dumps(list(commands.values())), encoding="utf-8")
    shared = environment(options.root, options.clang_tidy)
    passed = {source: options.cache / fingerprint(options.root, source, entry["command"], shared)
              for source, entry in commands.items()}
    todo = [source for source, mark in passed.items() if not mark.exists()]
    options.cache.mkdir(parents=True, exist_ok=True)

    faults = 0
    with ThreadPoolExecutor(options.jobs) as pool:
        for source, findings in zip(todo, pool.map(lambda file: check(options.clang_tidy, database, file), todo)):
            if findings:
                faults += 1
                print(findings, file=sys.stderr)
            else:
                passed[source].touch()
    print(f"clang-tidy: {len(todo)} of {len(passed)} sources checked, {faults} with findings")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
