"""Write the record of a trial that died before it could write one itself: see RECORD.md.

Reads what the trial printed on standard input; its last line becomes part of the reason.
"""

import argparse
import json
import os
import signal
import sys


def reason(exit_code: int, output: str) -> str:
    """Why the trial ended, in one line; `exit_code` as a shell reports it (128 + signal)."""
    if exit_code > 128:
        how = f"killed by {signal.Signals(exit_code - 128).name}"
    elif exit_code == 0:
        how = "ended well but left no record"
    else:
        how = f"exit code {exit_code}"
    lines = output.strip().splitlines()
    return f"{how}: {lines[-1]}" if lines else how


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("record", help="file to write")
    parser.add_argument("--exit-code", type=int, required=True)
    parser.add_argument("--study", required=True)
    parser.add_argument("--id", required=True)
    parser.add_argument("--command", required=True, help="command line that repeats the trial")
    args = parser.parse_args()
    record = {
        "schema": 1,
        "status": "failed",
        "error": reason(args.exit_code, sys.stdin.buffer.read().decode(errors="replace")),
        "command": args.command,
        "study": args.study,
        "id": args.id,
    }
    unfinished = args.record + ".part"
    with open(unfinished, "w", encoding="utf-8") as file:
        json.dump(record, file, indent=1)
        file.write("\n")
    os.replace(unfinished, args.record)


if __name__ == "__main__":
    main()
