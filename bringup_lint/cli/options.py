"""Options that several commands share."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from bringup_lint.config import NEWEST_SYSTEMD
from bringup_lint.config import OLDEST_SYSTEMD
from bringup_lint.config import ROS_DISTROS
from bringup_lint.config import SEVERITIES

Command = Callable[..., Any]

rules_option = click.option(
    "--rules",
    "rule_folders",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="FOLDER",
    multiple=True,
    help="Folder of further rules.",
)
root_option = click.option(
    "--root",
    type=click.Path(exists=True, file_okay=False),
    metavar="FOLDER",
    help="Check a mounted root file system.",
)


def _together(*options: Callable[[Command], Command]) -> Callable[[Command], Command]:
    """Several options as one decorator, in the order of the help."""

    def decorate(command: Command) -> Command:
        for option in reversed(options):
            command = option(command)
        return command

    return decorate


def names(ctx: click.Context, param: click.Parameter, value: tuple[str, ...]) -> tuple[str, ...]:
    """Option values, each of which may hold several names between commas."""
    return tuple(name.strip() for item in value for name in item.split(",") if name.strip())


ros_option = click.option(
    "--target-ros", type=click.Choice(ROS_DISTROS), help="The ROS distribution that the robot runs."
)
target_options = _together(
    ros_option,
    click.option(
        "--target-systemd",
        type=click.IntRange(OLDEST_SYSTEMD, NEWEST_SYSTEMD),
        help="The systemd version that the robot runs.",
    ),
    click.option(
        "--now", type=click.DateTime(["%Y-%m-%d"]), help="Judge validity dates as on this day. [default: today]"
    ),
)
configuration_file_options = _together(
    click.option(
        "--config", "config_path", type=click.Path(dir_okay=False, path_type=Path), help="Configuration file."
    ),
    click.option("--isolated", is_flag=True, help="Read no configuration file."),
)
exclude_option = click.option("--exclude", multiple=True, help="Skip what matches this gitignore pattern.")
configuration_options = _together(configuration_file_options, rules_option, exclude_option)
verdict_options = _together(
    click.option("--ignore", multiple=True, callback=names, help="Leave these rules or families out."),
    click.option("--min-severity", type=click.Choice(SEVERITIES), help="Lowest severity to show. [default: warning]"),
    click.option("--fail-on", type=click.Choice(SEVERITIES), help="Lowest severity that fails. [default: warning]"),
    click.option("--exit-zero", is_flag=True, help="Exit with 0 whatever is found."),
)
ignores_option = click.option("--no-ignores", is_flag=True, help="Show what comments and the configuration suppress.")
changes_options = _together(
    click.option("--since", metavar="REV", help="Show what the changes since a git revision have a part in."),
    click.option("--changed", is_flag=True, help="PATHs are changed files: show what they have a part in."),
)
baseline_options = _together(
    click.option("--baseline", type=click.Path(dir_okay=False, path_type=Path), help="Leave out what this file holds."),
    click.option(
        "--write-baseline",
        type=click.Path(dir_okay=False, path_type=Path),
        help="Write the findings to a baseline, and report none of them.",
    ),
    click.option("--prune-baseline", is_flag=True, help="Take out of the baseline what is not found any more."),
)
shown_options = _together(
    click.option("--statistics", is_flag=True, help="Print a table of the rules in place of the findings."),
    click.option("--quiet", "-q", is_flag=True, help="Print the findings alone: no summary, no notes, no progress."),
    click.option("--show-files", is_flag=True, help="List the files that would be checked, with their kinds."),
    click.option("--show-settings", is_flag=True, help="Print each setting, and what says so."),
)
cache_options = _together(
    click.option("--no-cache", is_flag=True, help="Look at everything again, and keep nothing."),
    click.option(
        "--cache-by",
        type=click.Choice(("times", "content")),
        default="times",
        help="How an unchanged file is known. [default: times]",
    ),
)
colour_option = click.option("--colour/--no-colour", "--color/--no-color", default=None, help="Force or forbid colour.")
