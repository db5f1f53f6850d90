"""The arguments of public launch files."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple

OF_LAUNCH = frozenset(
    ("emulate_tty", "launch-prefix", "launch-prefix-filter", "ros_namespace", "sigkill_timeout", "sigterm_timeout")
)
"""The launch configurations that launch and launch_ros read themselves, for every process that they start."""


class Taken(NamedTuple):
    """What a public launch file takes, in any distribution."""

    arguments: frozenset[str]
    required: frozenset[str]
    """Those without a default in every distribution."""
    grows: bool
    """Releases have had others, or may have."""


def taken(package: str, file: str) -> Taken | None:
    """By package and the name of the file; None when nothing is known of it."""
    return _by_file().get((package, file))


@cache
def _by_file() -> dict[tuple[str, str], Taken]:
    found = {}
    for row in table("ros/launch_arguments"):
        known = Taken(frozenset(row["arguments"].split()), frozenset(row["required"].split()), row["grows"] == "yes")
        found.update({(row["package"], file): known for file in row["files"].split()})
    return found
