"""``bringup-lint fleet PATH...``: judge many robots together."""

from __future__ import annotations

import os
import secrets
import sys
import time
from collections.abc import Iterable
from collections.abc import Iterator
from datetime import date
from pathlib import Path
from typing import TYPE_CHECKING
from typing import Any

import click

from bringup_lint.cli.checking import configuration
from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import configuration_options
from bringup_lint.cli.options import ignores_option
from bringup_lint.cli.options import names
from bringup_lint.cli.options import target_options
from bringup_lint.cli.options import verdict_options
from bringup_lint.cli.outputs import PairedOptions
from bringup_lint.cli.outputs import file_option
from bringup_lint.cli.reports import Output
from bringup_lint.cli.reports import write
from bringup_lint.cli.streams import complain
from bringup_lint.cli.terminal import terminal_width
from bringup_lint.cli.terminal import wants_colour
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import replace
from bringup_lint.report.fleet import FORMATS
from bringup_lint.report.fleet import FleetReport

if TYPE_CHECKING:
    from bringup_lint.fleet.check import Job
    from bringup_lint.fleet.members import Inventory
    from bringup_lint.fleet.members import Member
    from bringup_lint.fleet.state import State
    from bringup_lint.fleet.summary import Summary

NO_ROBOT = (
    "no file of a robot was found: give a folder or a tar archive with the files of each robot, "
    "a fleet.toml or a folder that holds one, or an Ansible inventory"
)


@click.command(cls=PairedOptions, context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("paths", nargs=-1, required=True, type=click.Path(readable=False), metavar="PATH...")
@click.option(
    "--output-format", type=click.Choice(FORMATS), multiple=True, help="How to report; may be repeated. [default: text]"
)
@file_option
@click.option("--workers", type=click.IntRange(1), help="Worker processes. [default: one a processor]")
@click.option("--scheduler", metavar="ADDRESS", help="Work on this dask cluster; 'local' starts one.")
@click.option("--state", type=click.Path(file_okay=False, path_type=Path), help="Keep summaries here, to go on later.")
@click.option("--select", multiple=True, callback=names, help="Run only these rules or families.")
@verdict_options
@target_options
@ignores_option
@configuration_options
@colour_option
@click.pass_context
def command(ctx: click.Context, paths: tuple[str, ...], **options) -> None:
    """Judge many robots together: keys they share, addresses that collide, settings that have drifted apart.

    PATH is a folder or a tar archive with the files of one robot, a fleet.toml or a folder that holds one, or an
    Ansible inventory. Each robot is checked as by itself, too.
    """
    from bringup_lint.registry import RuleError
    from bringup_lint.writing import NotWritten

    try:
        code = _judge(ctx.meta["outputs"], paths, options)
    except (ConfigError, RuleError, NotWritten) as error:
        complain(error)
        code = 2
    ctx.exit(code)


def _judge(outputs: list[Output], paths: tuple[str, ...], options: dict[str, Any]) -> int:
    from bringup_lint.fleet.check import Job
    from bringup_lint.fleet.inventory import read_inventory
    from bringup_lint.fleet.render import rendered

    config, rule_folders = configuration(paths, {**options, "root": None, "baseline": None})
    inventory = read_inventory(paths)
    today = options["now"].date() if options["now"] else date.today()
    state = None
    if options["state"]:
        from bringup_lint.fleet.state import State

        state = State(options["state"])
    key = secrets.token_bytes(32) if state is None else state.key
    job = Job(config, key, today, tuple(rule_folders), not options["no_ignores"])
    report = fleet_report(_gathered(inventory, job, state, options), inventory, job)
    report = replace(report, width=terminal_width())
    if _is_empty(inventory, report):
        raise ConfigError(NO_ROBOT)
    code = report.exit_code
    for output in outputs:
        colour = output.file is None and wants_colour(options["colour"])
        text, failures = rendered(output.format, replace(report, colour=colour))
        code = 3 if failures else code
        for failure in failures:
            complain(failure)
        write(text, output.file)
    return 0 if options["exit_zero"] and code == 1 else code


def _is_empty(inventory: Inventory, report: FleetReport) -> bool:
    """Whether all that was given are folders in which no file says anything."""
    if any(robot.files or robot.marks or robot.facts or robot.failures for robot in report.robots):
        return False
    return all(os.path.isdir(path) for member in inventory.members for path in member.layers)


def fleet_report(summaries: Iterable[Summary], inventory: Inventory, job: Job) -> FleetReport:
    """Everything that a format may say about a fleet. Raises ConfigError."""
    from bringup_lint.finding import Severity
    from bringup_lint.fleet.fleet import Fleet
    from bringup_lint.fleet.judge import judge
    from bringup_lint.registry import Registry
    from bringup_lint.registry import doc_of

    robots = tuple(sorted(summaries, key=lambda summary: summary.name))
    registry = Registry.of(job.rule_folders)
    verdict = judge(Fleet(robots), registry, job.config, inventory.accepted, ignores=job.ignores)
    own = {finding.rule for robot in robots for finding in robot.own}
    known = [rule for rule in map(registry.get, sorted(own)) if rule is not None]
    report = FleetReport(
        robots,
        verdict.findings,
        {rule.id: doc_of(rule) for rule in (*verdict.rules.values(), *known)},
        verdict.failures,
        verdict.hidden,
        root=os.getcwd(),
    )
    return replace(report, exit_code=_exit_code(report, Severity[job.config.fail_on.upper()]))


def _exit_code(report: FleetReport, fail_on: int) -> int:
    """3 when something failed inside, 1 for findings as severe as ``fail_on``, else 0."""
    from bringup_lint.finding import Severity

    if report.failures or any(robot.failures for robot in report.robots):
        return 3
    severities = [found.severity for found in report.shown]
    severities += [Severity[own.severity.upper()] for robot in report.robots for own in robot.own]
    return int(any(severity >= fail_on for severity in severities))


def _gathered(inventory: Inventory, job: Job, state: State | None, options: dict[str, Any]) -> Iterator[Summary]:
    """The summaries, with the progress on the terminal."""
    started = time.monotonic()
    total = len(inventory.members)
    shown = sys.stderr.isatty()
    for number, summary in enumerate(_summaries(inventory, job, state, options), 1):
        if shown:
            rate = number / max(time.monotonic() - started, 0.001)
            click.echo(f"\r{number} of {total} robots, {rate:.1f} a second ", err=True, nl=number == total)
        yield summary


def _summaries(inventory: Inventory, job: Job, state: State | None, options: dict[str, Any]) -> Iterator[Summary]:
    """Those that are kept from an earlier run, then those that are made now."""
    if state is None:
        yield from _made(inventory.members, job, options)
        return
    names = {member.name: state.name(member, job) for member in inventory.members}
    left = []
    for member in inventory.members:
        kept = state.load(names[member.name])
        if kept is None:
            left.append(member)
        else:
            yield kept
    for summary in _made(left, job, options):
        state.save(names[summary.name], summary)
        yield summary


def _made(members: Iterable[Member], job: Job, options: dict[str, Any]) -> Iterator[Summary]:
    if options["scheduler"]:
        from bringup_lint.fleet.cluster import on_cluster

        return on_cluster(members, job, options["scheduler"])
    from bringup_lint.fleet.work import summaries

    return summaries(members, job, options["workers"] or os.cpu_count() or 1)
