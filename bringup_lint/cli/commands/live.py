"""``bringup-lint live [PATH]...``: compare the running ROS graph with the files."""

from __future__ import annotations

import os
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING
from typing import Any

import click

from bringup_lint.cli.checking import deliver
from bringup_lint.cli.configuring import configuration
from bringup_lint.cli.options import baseline_options
from bringup_lint.cli.options import colour_option
from bringup_lint.cli.options import configuration_file_options
from bringup_lint.cli.options import exclude_option
from bringup_lint.cli.options import ignores_option
from bringup_lint.cli.options import names
from bringup_lint.cli.options import root_option
from bringup_lint.cli.options import ros_option
from bringup_lint.cli.options import verdict_options
from bringup_lint.cli.outputs import PairedOptions
from bringup_lint.cli.outputs import file_option
from bringup_lint.cli.outputs import format_option
from bringup_lint.cli.reading import read_robot
from bringup_lint.cli.reports import Output
from bringup_lint.cli.reports import write
from bringup_lint.cli.run_options import RunOptions
from bringup_lint.cli.streams import complain
from bringup_lint.cli.streams import say
from bringup_lint.cli.usage import baseline_usage
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import replace
from bringup_lint.plural import counted

if TYPE_CHECKING:
    from bringup_lint.graph.observed.observed import Observed
    from bringup_lint.robot import Robot
    from bringup_lint.source import Located
    from bringup_lint.source import Source

MOST_PARAMETERS = 1000
FAMILY = "live"
KIND = "observed-graph"


@click.command(cls=PairedOptions, context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("paths", nargs=-1, type=click.Path(readable=False), metavar="[PATH]...")
@click.option(
    "--domain-id", type=click.IntRange(0, 232), help="Domain to look at. [default: the shell's, else the files']"
)
@click.option("--wait", type=click.FloatRange(0.1, 60), default=3.0, show_default=True, help="Seconds of discovery.")
@click.option(
    "--launch",
    "launched",
    multiple=True,
    metavar="COMMAND",
    help="What was launched: '[PACKAGE] FILE [NAME:=VALUE]...'.",
)
@click.option("--enclave", help="The enclave to join with, when ROS_SECURITY_ENABLE is set.")
@click.option("--save", type=click.Path(dir_okay=False, path_type=Path), help="Write what was seen to this file.")
@click.option("--load", type=click.Path(exists=True, dir_okay=False), help="Judge what --save wrote; look at nothing.")
@root_option
@format_option
@file_option
@click.option("--select", multiple=True, callback=names, help="Run only these rules or families. [default: live]")
@verdict_options
@ros_option
@ignores_option
@configuration_file_options
@exclude_option
@baseline_options
@colour_option
@click.pass_context
def command(ctx: click.Context, paths: tuple[str, ...], **options) -> None:
    """Compare the running ROS graph with the files.

    Joins a domain for some seconds as a hidden node that publishes nothing, and says where what runs is not what the
    files under PATH (by default the current folder) say. Needs rclpy: a sourced ROS, or the
    extra live.
    """
    from bringup_lint.live.run import LiveError
    from bringup_lint.registry import RuleError
    from bringup_lint.writing import NotWritten

    try:
        code = _compare(ctx.meta["outputs"], paths or ("/" if options["root"] else ".",), options)
    except (ConfigError, LiveError, NotWritten, RuleError) as error:
        complain(error)
        code = 2
    ctx.exit(code)


def _compare(outputs: list[Output], paths: tuple[str, ...], options: dict[str, Any]) -> int:
    from bringup_lint.engine import run
    from bringup_lint.registry import Registry

    started = time.time()
    of_run = RunOptions.of(options)
    config, _ = configuration(paths, of_run)
    baseline_usage(config, of_run)
    config = replace(config, select=of_run.select or (FAMILY,))
    robot = read_robot(paths, config, of_run)
    robot.launch_commands = options["launched"]
    _known(robot)
    robot.join(loaded(options["load"]) if options["load"] else seen(robot, options))
    observed = robot.observed
    if observed.graph.problems:
        raise ConfigError(f"{options['load']}: not a graph that bringup-lint live --save wrote")
    _tell(robot, observed)
    outcome = run(robot, Registry.of(), config, ignores=not of_run.no_ignores)
    return deliver(outcome, robot, config, started, outputs, of_run)


def _known(robot: Robot) -> None:
    """Raises ConfigError when ``--launch`` names no launch file of the tree."""
    from bringup_lint.graph.observed.expected import launch_file

    for command in robot.launch_commands:
        try:
            file = launch_file(robot.tree, robot.launch, command)
        except ValueError as error:
            raise ConfigError(f"--launch '{command}': {error}") from error
        if file is None:
            raise ConfigError(f"--launch '{command}': this is not one launch file of the tree")


def loaded(path: str) -> Source:
    """A graph that was saved. Raises ConfigError when the file cannot be read."""
    from bringup_lint.discover.reading import Unreadable
    from bringup_lint.discover.reading import read_bytes
    from bringup_lint.source import Source

    try:
        return Source(path, read_bytes(path, follow=True)[0].decode("utf-8", "replace"), KIND)
    except Unreadable as error:
        raise ConfigError(f"{path}: {error}") from error


def seen(robot: Robot, options: dict[str, Any]) -> Source:
    """The running graph. Raises LiveError when it cannot be looked at."""
    from bringup_lint.graph.observed.domains import mentioned
    from bringup_lint.graph.observed.domains import middleware
    from bringup_lint.live.ports import open_domains
    from bringup_lint.live.run import AGAIN
    from bringup_lint.live.run import AT_MOST
    from bringup_lint.live.run import look
    from bringup_lint.live.run import merged
    from bringup_lint.live.systemd import units as running_units
    from bringup_lint.live.text import graph_text
    from bringup_lint.parsers.observed import parse
    from bringup_lint.source import Source

    domain, told = chosen(robot, options["domain_id"])
    said = None if os.environ.get("RMW_IMPLEMENTATION") else middleware(robot.ros)
    rmw = str(said) if said else None
    with_rmw = f" with {rmw} ({_at(said)})" if said else ""
    say(f"Looking at domain {domain} ({told}){with_rmw} ...")
    how: dict[str, Any] = {"enclave": options["enclave"], "rmw": rmw, "parameters": asked_parameters(robot)}
    with ThreadPoolExecutor(1) as pool:
        looking = pool.submit(look, [domain], options["wait"], **how)
        _ = robot.expected
        (graph,) = looking.result()
    secured = os.environ.get("ROS_SECURITY_ENABLE") == "true"
    units = running_units(unit.name for unit in robot.units.judged if unit.manager == "system")
    text = graph_text(graph, [], told, secured, units)
    observed = robot.compared(parse(Source("", text)))
    if observed.wants or (observed.configured and observed.configured.number != domain):
        unseen = [] if observed.nodes else open_domains()
        others = [each for each in dict.fromkeys([*mentioned(robot.ros), *unseen]) if each != domain][:AT_MOST]
        also = f", and at {', '.join(map(str, others))}" if others else ""
        say(f"Looking longer, for what is not there{also} ...")
        again, *elsewhere = look([domain, *others], AGAIN * options["wait"], **how)
        text = graph_text(merged(graph, again), elsewhere, told, secured, units)
    if options["save"]:
        write(text, options["save"])
        return Source(str(options["save"]), text, KIND)
    return Source(f"<ROS graph, domain {domain}>", text, KIND, virtual=True)


def asked_parameters(robot: Robot) -> dict[str, list[str]]:
    """The names of the parameters that files give nodes, by node; of very many the first."""
    from bringup_lint.graph.observed.parameters import given

    names: dict[str, list[str]] = {}
    for each in given(robot.params)[:MOST_PARAMETERS]:
        names.setdefault(each.node, []).append(each.name)
    return names


def chosen(robot: Robot, given: int | None) -> tuple[int, str]:
    """The domain to look at, and what says so. Raises ConfigError for a ``ROS_DOMAIN_ID`` that is none."""
    from bringup_lint.graph.observed.domains import configured
    from bringup_lint.parsers.ros_values import MAX_DOMAIN
    from bringup_lint.parsers.ros_values import domain_id

    if given is not None:
        return given, "--domain-id"
    own = os.environ.get("ROS_DOMAIN_ID")
    if own:
        number = domain_id(own).number
        if number is None or number > MAX_DOMAIN:
            raise ConfigError(f"ROS_DOMAIN_ID is '{own}' in this shell, which is not a domain")
        return number, "ROS_DOMAIN_ID of this shell"
    told = configured(robot.ros)
    return (told.number, _at(told.where)) if told else (0, "the default")


def _at(where: Located) -> str:
    return f"{where.path}:{where.line}"


def _tell(robot: Robot, observed: Observed) -> None:
    """What the files leave open, so that a rule stays silent; on standard error."""
    expected, nodes = robot.expected, len(observed.nodes)
    say(f"Domain {observed.graph.domain} shows {counted(nodes, 'node')}, tools left out.")
    for domain, others in observed.elsewhere.items():
        if others and not nodes:
            shown = ", ".join(str(node.name) for node in others[:3]) + (", ..." if len(others) > 3 else ".")
            say(f"Domain {domain} shows {len(others)}: {shown} Look there with --domain-id {domain}.")
    if expected.ambiguous:
        said = "Several launch files, and nothing says which one runs: name it with --launch to hear of missing nodes."
        say(said)
    if expected.gaps:
        where, why = expected.gaps[0]
        more = f", and {len(expected.gaps) - 1} more" if len(expected.gaps) > 1 else ""
        say(f"Unexpected nodes are not judged: {where.path}:{where.line}: {why}{more}.")
