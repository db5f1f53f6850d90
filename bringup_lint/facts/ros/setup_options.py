"""What setuptools takes in setup.cfg."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import rows

SECTIONS = (
    *("metadata", "options", "options.entry_points", "options.package_data", "options.data_files"),
    *("options.packages.find", "options.extras_require", "options.exclude_package_data"),
)
"""The sections of setuptools that are no commands."""


@cache
def setup_options() -> dict[str, frozenset[str]]:
    """Command -> its options."""
    return {command: frozenset(options.split()) for command, options in rows("ros/setup_options")[1]}
