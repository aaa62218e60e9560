"""Trials on the cores of this machine."""

import resource

from progress import Progress
from study_folder import Study
from trial_pool import Outcome, Pool


def run(study: Study, todo: list[str], jobs: int, lock_handle: int) -> dict[str, str]:
    """Run the trials `todo`; why each of the failed ones did.

    @raises Interrupted after everything running has been ended.
    """
    errors = {}
    before = children_cpu_s()
    with Progress(f"study {study.label}", len(todo)) as progress:

        def note(outcome: Outcome) -> None:
            if outcome.error is not None:
                errors[outcome.trial] = outcome.error
            progress.count(failed=outcome.error is not None)

        Pool(study.work(), jobs, lock_handle).run(todo, note, progress.show)
    study.write_pace((children_cpu_s() - before) / len(todo))
    return errors


def children_cpu_s() -> float:
    """Processor time of all descendants that have ended."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime
