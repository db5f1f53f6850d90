"""``bringup-lint graph [PATH]...``: draw what starts what, in which order and with what."""

from __future__ import annotations

import time
from importlib import import_module
from pathlib import Path
from typing import Any

import click

from bringup_lint.cli.options import configuration_options
from bringup_lint.cli.options import root_option
from bringup_lint.cli.options import target_options
from bringup_lint.cli.reports import write
from bringup_lint.cli.streams import complain
from bringup_lint.config import ConfigError
from bringup_lint.graph.layers import LAYERS

FORMATS = ("dot", "mermaid", "json", "html")


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("paths", nargs=-1, type=click.Path(readable=False), metavar="[PATH]...")
@click.option(
    "--format", "output_format", type=click.Choice(FORMATS), default="dot", show_default=True, help="How to draw."
)
@click.option(
    "--output-file", type=click.Path(dir_okay=False, path_type=Path), help="Where to. [default: standard output]"
)
@click.option("--focus", multiple=True, metavar="NAME", help="Only what leads to this unit, node or file, and from it.")
@click.option("--depth", type=click.IntRange(0), help="With --focus: at most so many steps away.")
@click.option("--layer", "layers", type=click.Choice(list(LAYERS)), multiple=True, help="Only this layer.")
@root_option
@target_options
@configuration_options
@click.pass_context
def command(ctx: click.Context, paths: tuple[str, ...], **options: Any) -> None:
    """Draw what starts what on a robot: units, launch files, nodes and what they need, with the findings.

    \b
    bringup-lint graph --format mermaid --focus robot.service .
    """
    from bringup_lint.registry import RuleError
    from bringup_lint.report.picture.selection import NothingFound
    from bringup_lint.writing import NotWritten

    if options["depth"] is not None and not options["focus"]:
        raise click.UsageError("--depth needs a --focus")
    try:
        write(_draw(paths or ("/" if options["root"] else ".",), options), options["output_file"])
    except (ConfigError, NothingFound, NotWritten, RuleError) as error:
        complain(error)
        ctx.exit(2)


def _draw(paths: tuple[str, ...], options: dict[str, Any]) -> str:
    from bringup_lint.cli.configuring import configuration
    from bringup_lint.cli.reading import read_robot
    from bringup_lint.cli.reporting import report_of
    from bringup_lint.cli.run_options import RunOptions
    from bringup_lint.engine import run
    from bringup_lint.registry import Registry
    from bringup_lint.report.picture.selection import focused
    from bringup_lint.report.picture.selection import in_layers

    settings = RunOptions.of(options)
    config, rule_folders = configuration(paths, settings)
    robot = read_robot(paths, config, settings)
    outcome = run(robot, Registry.of(rule_folders), config)
    for failure in (*outcome.failures, *(f"the picture is not whole: {error!r}" for error in robot.graph.failures)):
        complain(failure)
    document = report_of(outcome, robot, config, time.time(), drawn=True).picture
    assert document is not None, "it was asked for"
    if options["focus"]:
        document = focused(document, options["focus"], options["depth"])
    if options["layers"]:
        document = in_layers(document, options["layers"])
    return import_module(f"bringup_lint.report.picture.{options['output_format']}").render(document)
