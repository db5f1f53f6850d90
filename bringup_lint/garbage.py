"""How often Python searches for garbage while robots are read."""

from __future__ import annotations

import gc

YOUNG_OBJECTS = 500_000
"""How many objects more than before start the search in a run: more than a repository of 3,000 files has."""
OF_MANY_RUNS = 200_000
"""The same where runs follow each other: what a robot leaves is garbage, as its layers know each other."""


def collect_seldom() -> None:
    """Nearly all objects of a run live until its end, so that the search for garbage, which Python starts every 700
    objects, finds none and takes a fifth of the time in a big repository."""
    gc.set_threshold(YOUNG_OBJECTS, 20, 100)


def collect_between_runs() -> None:
    """For a process that reads a robot again and again, such as the server of an editor."""
    gc.set_threshold(OF_MANY_RUNS, 20, 100)
