"""A progress bar with an estimate on a terminal; a line now and then elsewhere."""

import sys
from typing import Self

from tqdm import tqdm

TEXT = "{desc}: {n_fmt}/{total_fmt}{postfix}, {elapsed} so far, {remaining} left"
LINE_INTERVAL_S = 30.0


class Lines:
    """What tqdm draws over and over again, as lines of their own."""

    def write(self, text: str) -> None:
        line = text.strip("\r\n ")
        if line:
            print(line, file=sys.stderr, flush=True)

    def flush(self) -> None:
        pass


class Progress:
    """Counts finished trials of `total`; `show` may be called as often as one likes."""

    def __init__(self, label: str, total: int):
        tqdm.monitor_interval = 0  # no thread that draws: `show` does
        terminal = sys.stderr.isatty()
        look = ({"bar_format": "{bar} " + TEXT, "dynamic_ncols": True, "mininterval": 0.1} if terminal else
                {"bar_format": TEXT, "file": Lines(), "mininterval": LINE_INTERVAL_S,
                 "delay": LINE_INTERVAL_S, "leave": False})
        # The mean over all trials: they come in rounds of cheap and costly ones.
        self._bar = tqdm(desc=label, total=total, smoothing=0, miniters=0, **look)
        self._failed = 0

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the last state standing on a terminal."""
        self._bar.close()

    def count(self, failed: bool) -> None:
        self._failed += failed
        if failed:
            self._bar.set_postfix_str(f"{self._failed} failed", refresh=False)
        self._bar.update()

    def show(self) -> None:
        self._bar.update(0)
