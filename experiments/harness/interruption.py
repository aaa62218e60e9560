"""Ctrl-C, a polite request to end, or a terminal that closes: one exception, once."""

import signal

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
