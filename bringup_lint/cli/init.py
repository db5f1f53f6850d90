"""``bringup-lint init``: a configuration file to start from."""

from __future__ import annotations

import json
from pathlib import Path

import click

from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import say
from bringup_lint.config import FILE_NAME
from bringup_lint.config import schema
from bringup_lint.writing import NotWritten
from bringup_lint.writing import create

START = """\
# bringup-lint's configuration; every key is optional. bringup-lint init --schema prints the JSON schema.

# The ROS distribution and systemd version that the robot runs; else they are read from the tree.
# target-ros = "jazzy"
# target-systemd = 255

# select = ["systemd", "env"]
# ignore = ["systemd/no-resource-limits"]
# exclude = ["simulation/"]
# min-severity = "warning"
# fail-on = "warning"

# [severity]
# "systemd/root-user" = "error"
# "node" = "off"

# [per-file-ignores]
# "legacy/" = ["systemd", "udev/symlink-match"]

# Where files of this repository go on the robot.
# [deploy]
# "deploy/systemd" = "/etc/systemd/system"
"""


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.option("--schema", "print_schema", is_flag=True, help="Print the JSON schema of the configuration instead.")
@click.pass_context
def command(ctx: click.Context, print_schema: bool) -> None:
    """Write bringup-lint.toml in the current folder."""
    if print_schema:
        click.echo(json.dumps(schema(), indent=2))
        return
    path = Path(FILE_NAME)
    try:
        create(path, START.encode("utf-8"))
    except NotWritten as error:
        complain(error)
        ctx.exit(2)
    say(f"Wrote {path}.")
