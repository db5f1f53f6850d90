"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from bringup_lint.config import ROS_DISTROS

Command = Callable[..., Any]

rules_option = click.option(
    "--rules",
    "rule_folders",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    multiple=True,
    help="Folder of further rules.",
)
root_option = click.option(
    "--root", type=click.Path(exists=True, file_okay=False), help="Check a mounted root file system."
)


def _together(*options: Callable[[Command], Command]) -> Callable[[Command], Command]:
    """Several options as one decorator, in the order of the help."""

    def decorate(command: Command) -> Command:
        for option in reversed(options):
            command = option(command)
        return command

    return decorate


target_options = _together(
    click.option("--target-ros", type=click.Choice(ROS_DISTROS), help="The ROS distribution that the robot runs."),
    click.option("--target-systemd", type=click.IntRange(245), help="The systemd version that the robot runs."),
    click.option(
        "--now", type=click.DateTime(["%Y-%m-%d"]), help="Judge validity dates as on this day. [default: today]"
    ),
)
configuration_options = _together(
    click.option(
        "--config", "config_path", type=click.Path(dir_okay=False, path_type=Path), help="Configuration file."
    ),
    click.option("--isolated", is_flag=True, help="Read no configuration file."),
    rules_option,
    click.option("--exclude", multiple=True, help="Skip what matches this gitignore pattern."),
)
