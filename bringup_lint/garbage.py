"""How often Python searches for garbage while robots are read."""

from __future__ import annotations

import gc

YOUNG_OBJECTS = 200_000
"""How many objects more than before start the search."""


def collect_seldom() -> None:
    """Nearly all objects of a run live until its end, so that the search for garbage, which Python starts every 700
    objects, finds none and takes a fifth of the time in a big repository."""
    gc.set_threshold(YOUNG_OBJECTS, 20, 100)
