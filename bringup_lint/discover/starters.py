"""The kinds of file that start processes. A new one is named here, and made into runners in ``graph/runners``."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple


class Starter(NamedTuple):
    kinds: tuple[str, ...]
    own: bool = True
    """Whether each robot has its own, so that two files of the kind in neighbouring folders are two robots."""


STARTERS = {
    "units": Starter(("systemd-unit", "systemd-dropin")),
    "services": Starter(("compose",)),
    "images": Starter(("dockerfile",), own=False),
    "cron": Starter(("cron",), own=False),
    "supervised_programs": Starter(("supervisord",)),
    "scripts": Starter(("shell-script",), own=False),
}
"""Module of ``graph/runners`` -> the kinds of which it makes runners. What others may start comes last."""

STARTING = frozenset(kind for starter in STARTERS.values() for kind in starter.kinds)
"""All of these kinds; the word ``runners`` in a ``family.toml`` stands for them."""
