"""Ctrl-C, a polite request to end, or a terminal that closes: one exception, once. One line for each end."""

import signal
import sys
from typing import Callable

EXIT_CODE = 130  # as of a shell


class Interrupted(Exception):
    """Raised wherever the program is; whoever started processes ends them and passes it on."""


def raise_when_interrupted() -> None:
    """From here on these signals raise `Interrupted`; any after the first are ignored."""
    signals = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)

    def interrupt(*_):
        for number in signals:
            signal.signal(number, signal.SIG_IGN)
        raise Interrupted

    for number in signals:
        signal.signal(number, interrupt)


def run(main: Callable[[], int]) -> int:
    """Exit code of a `main` that only prints: its own, or with one line on stderr 1 if a file cannot be read
    or run, 130 at Ctrl-C."""
    try:
        return main()
    except OSError as error:
        print(f"{error.filename}: {error.strerror}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return EXIT_CODE
