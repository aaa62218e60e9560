"""One task of a Slurm job: its share of a study's trials, on the node that it was given.

Of a task that was queued again, because its node was lost, only what has no record is run.
"""

import argparse
import json
import sys
from pathlib import Path

import interruption
import records
from trial_pool import Outcome, Pool, Work


def print_outcome(outcome: Outcome) -> None:
    print(f"{outcome.trial}: {outcome.error or 'good'}", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("share", type=Path, help="JSON file with `work` and `trials`")
    parser.add_argument("--jobs", type=int, required=True, help="trials at a time")
    args = parser.parse_args()
    share = json.loads(args.share.read_text(encoding="utf-8"))
    work = Work(**share["work"])
    finished = records.read_all(Path(work.records), share["trials"])
    todo = [trial for trial in share["trials"] if trial not in finished or not finished[trial].is_whole]
    interruption.raise_when_interrupted()
    try:
        Pool(work, args.jobs).run(todo, print_outcome, tick=lambda: None)
    except interruption.Interrupted:
        return interruption.EXIT_CODE
    except (records.OtherFiles, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
