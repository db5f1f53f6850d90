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

from bringup_lint.cli.configuring import configuration
from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import configuration_options
from bringup_lint.cli.options import ignores_option
from bringup_lint.cli.options import names
from bringup_lint.cli.options import target_options
from bringup_lint.cli.options import verdict_options
from bringup_lint.cli.outputs import PairedOptions
from bringup_lint.cli.outputs import file_option
from bringup_lint.cli.reports import Output
from bringup_lint.cli.reports import write_pieces
from bringup_lint.cli.run_options import RunOptions
from bringup_lint.cli.streams import complain
from bringup_lint.cli.terminal import terminal_width
from bringup_lint.cli.terminal import wants_colour
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import replace
from bringup_lint.plural import counted
from bringup_lint.report.fleet import FORMATS
from bringup_lint.report.fleet import FleetReport

if TYPE_CHECKING:
    from bringup_lint.fleet.check import Job
    from bringup_lint.fleet.members import Inventory
    from bringup_lint.fleet.members import Member
    from bringup_lint.fleet.state import State
    from bringup_lint.fleet.store import Store
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
@click.option(
    "--state",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="FOLDER",
    help="Keep summaries here, to go on later.",
)
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
    from bringup_lint.fleet.gather import stored
    from bringup_lint.fleet.hints import hint
    from bringup_lint.fleet.inventory import read_inventory
    from bringup_lint.fleet.render import rendered

    config, rule_folders = configuration(paths, RunOptions.of(options))
    inventory = read_inventory(paths)
    for said in filter(None, map(hint, inventory.members)):
        complain(said)
    today = options["now"].date() if options["now"] else date.today()
    state = None
    if options["state"]:
        from bringup_lint.fleet.state import State

        state = State(options["state"])
    key = secrets.token_bytes(32) if state is None else state.key
    job = Job(config, key, today, tuple(rule_folders), not options["no_ignores"], os.getcwd())
    store = stored(inventory.members, _shown(_summaries(inventory, job, state, options), len(inventory.members)))
    if state is not None and state.trouble:
        complain(state.trouble)
    report = replace(fleet_report(store, inventory, job), width=terminal_width())
    if not store.says_anything() and not any(map(_is_given, inventory.members)):
        raise ConfigError(NO_ROBOT)
    code = report.exit_code
    for output in outputs:
        colour = output.file is None and wants_colour(options["colour"])
        try:
            text = rendered(output.format, replace(report, colour=colour))
        except OSError as error:
            raise ConfigError(f"the report does not fit into the folder for temporary files: {error}") from error
        code = 3 if text.failures else code
        for failure in text.failures:
            complain(failure)
        write_pieces(text.pieces, output.file)
    return 0 if options["exit_zero"] and code == 1 else code


def _is_given(member: Member) -> bool:
    """Whether more than folders says that there is a robot."""
    return bool(member.delivered) or not all(map(os.path.isdir, member.layers))


def fleet_report(store: Store, inventory: Inventory, job: Job) -> FleetReport:
    """Everything that a format may say about a fleet. Raises ConfigError."""
    from bringup_lint.finding import Severity
    from bringup_lint.fleet.fleet import Fleet
    from bringup_lint.fleet.judge import judge
    from bringup_lint.registry import Registry
    from bringup_lint.registry import doc_of

    registry = Registry.of(job.rule_folders)
    verdict = judge(Fleet(store), registry, job.config, inventory.accepted, ignores=job.ignores)
    own = {finding.rule for robot in store for finding in robot.own}
    known = [rule for rule in map(registry.get, sorted(own)) if rule is not None]
    report = FleetReport(
        store,
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

    highest = max((found.severity for found in report.shown), default=-1)
    failed = bool(report.failures)
    for robot in report.robots:
        failed |= bool(robot.failures)
        highest = max([highest, *(Severity[own.severity.upper()] for own in robot.own)])
    return 3 if failed else int(highest >= fail_on)


def _shown(summaries: Iterable[Summary], total: int) -> Iterator[Summary]:
    """The summaries, with the progress on the terminal."""
    started = time.monotonic()
    shown = sys.stderr.isatty()
    for number, summary in enumerate(summaries, 1):
        if shown:
            rate = number / max(time.monotonic() - started, 0.001)
            click.echo(f"\r{number} of {counted(total, 'robot')}, {rate:.1f} a second ", err=True, nl=number == total)
        yield summary


def _summaries(inventory: Inventory, job: Job, state: State | None, options: dict[str, Any]) -> Iterator[Summary]:
    """Those that are kept from an earlier run, and those that are made now."""
    if state is None:
        return _made(inventory.members, job, options)
    return state.resumed(inventory.members, job, lambda robots: _made(robots, job, options))


def _made(robots: Iterable[Member | Summary], job: Job, options: dict[str, Any]) -> Iterator[Summary]:
    if options["scheduler"]:
        from bringup_lint.fleet.cluster import on_cluster

        return on_cluster(robots, job, options["scheduler"])
    from bringup_lint.fleet.work import summaries

    return summaries(robots, job, options["workers"] or os.cpu_count() or 1)
