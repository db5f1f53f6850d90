"""A line on the terminal that says how far a run is, from its second second on."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager

from bringup_lint.cli.streams import overwrite
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from threading import Event

PATIENCE = 1.0
"""Seconds until the first line."""
PERIOD = 0.2


@dataclass
class Progress:
    """What is being done. A thread of its own writes the line, so that a long step is seen too."""

    what: str = "reading the files"
    rules: int = 0
    started: float = field(default_factory=time.monotonic)

    def rule(self) -> None:
        """Called before each rule."""
        self.rules += 1
        self.what = f"rule {self.rules}"

    def line(self) -> str:
        return f"bringup-lint: {self.what} ({time.monotonic() - self.started:.0f} s)"

    def show(self, done: Event) -> None:
        """Write the line until the run is done, then take it away."""
        shown = False
        while not done.wait(PERIOD if shown else PATIENCE):
            overwrite(self.line())
            shown = True
        if shown:
            overwrite("")


@contextmanager
def progress(wanted: bool) -> Iterator[Progress]:
    """Show how far the run is, where standard error is a terminal."""
    state = Progress()
    if not wanted or sys.stderr is None or not sys.stderr.isatty() or os.environ.get("TERM") == "dumb":
        yield state
        return
    from threading import Event
    from threading import Thread

    done = Event()
    thread = Thread(target=state.show, args=(done,), daemon=True)
    thread.start()
    try:
        yield state
    finally:
        done.set()
        thread.join()
