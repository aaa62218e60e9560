"""A progress bar with an estimate on a terminal; a line now and then elsewhere."""

import shutil
import sys
import time


def duration(seconds: float) -> str:
    """`seconds` as 42 s, 3 min 05 s or 2 h 07 min."""
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"


class Progress:
    """Counts finished trials of `total`; `show` may be called as often as one likes."""

    BAR_INTERVAL_S = 0.2
    LINE_INTERVAL_S = 30.0

    def __init__(self, label: str, total: int):
        self._label = label
        self._total = total
        self._done = 0
        self._failed = 0
        self._terminal = sys.stderr.isatty()
        self._start = self._shown = time.monotonic()

    def count(self, failed: bool) -> None:
        self._done += 1
        self._failed += failed

    def show(self) -> None:
        now = time.monotonic()
        interval = self.BAR_INTERVAL_S if self._terminal else self.LINE_INTERVAL_S
        if now - self._shown >= interval:
            self._shown = now
            self._write()

    def finish(self) -> None:
        """Leave the last state standing on a terminal."""
        if self._terminal:
            self._write()
            print(file=sys.stderr)

    def _write(self) -> None:
        text = self._text(time.monotonic() - self._start)
        if not self._terminal:
            print(text, file=sys.stderr, flush=True)
            return
        width = shutil.get_terminal_size().columns
        room = width - len(text) - 4
        if room >= 10:
            filled = room * self._done // self._total
            text = f"[{'#' * filled}{'.' * (room - filled)}] {text}"
        print(f"\r\033[K{text[:width - 1]}", end="", file=sys.stderr, flush=True)

    def _text(self, elapsed: float) -> str:
        text = f"{self._label}: {self._done}/{self._total}"
        if self._failed:
            text += f", {self._failed} failed"
        text += f", {duration(elapsed)}"
        if 0 < self._done < self._total:
            text += f", about {duration(elapsed / self._done * (self._total - self._done))} left"
        return text
