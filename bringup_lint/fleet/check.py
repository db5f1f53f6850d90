"""The work on one robot: read it, check it as a run on it alone does, reduce it to its summary."""

from __future__ import annotations

import os
import re
import time
from collections.abc import Callable
from collections.abc import Container
from datetime import date

from bringup_lint.config import Config
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import replace
from bringup_lint.discover.exclude import exclusion
from bringup_lint.discover.tree import Tree
from bringup_lint.discover.tree import display_name
from bringup_lint.discover.walk import discover
from bringup_lint.engine import run
from bringup_lint.finding import Finding
from bringup_lint.finding.place import place_of
from bringup_lint.finish import Invocation
from bringup_lint.finish import finish
from bringup_lint.fleet.members import Member
from bringup_lint.fleet.reduce.reduce import identified
from bringup_lint.fleet.reduce.reduce import reduced
from bringup_lint.fleet.summary import Own
from bringup_lint.fleet.summary import Summary
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot

TOPS = ("etc", "usr", "opt", "home", "root", "var", "lib", "run", "srv")
"""Folders that lie at the top of a snapshot of a robot."""


@dataclass(frozen=True)
class Job:
    """What is alike for all robots of a run; it travels to the workers."""

    config: Config
    key: bytes
    today: date
    rule_folders: tuple[str, ...] = ()
    ignores: bool = True
    folder: str = "/"
    """The working folder of the run, which relative paths are of."""


def summary_of(member: Member, job: Job) -> Summary:
    """Check one robot. What cannot be read becomes a failure of the summary."""
    empty = Summary(
        member.name,
        member.role,
        member.site,
        member.domain,
        member.talks,
        " + ".join(display_name(os.path.abspath(layer)) for layer in member.layers),
    )
    if not member.layers:
        return _with_delivered(empty, member, job)
    try:
        tree = tree_of(member, job.config)
    except (OSError, ValueError) as error:
        return replace(empty, failures=(f"not read: {error}",))
    robot = Robot(tree, job.config.target_ros, job.config.target_systemd, job.today)
    outcome = run(robot, Registry.of(job.rule_folders), job.config, ignores=job.ignores)
    report = finish(outcome, robot, Invocation((), os.getcwd(), time.time()))
    said, failures = reduced(robot, job.key)
    named = _names_of(member)
    summary = replace(
        empty,
        files=report.files,
        marks=tuple(mark._replace(path=named(mark.path)) for mark in said.marks),
        facts=tuple(fact._replace(path=named(fact.path)) for fact in said.facts),
        own=tuple(own._replace(path=named(own.path), message=named(own.message)) for own in map(_own, report.shown)),
        silenced=tuple(report.silenced),
        failures=(*outcome.failures, *failures),
    )
    return _with_delivered(summary, member, job, frozenset(said.places))


def _with_delivered(summary: Summary, member: Member, job: Job, present: Container[str] = ()) -> Summary:
    """The summary with what identifies the robot in the files that playbooks copy to it. What lies on it counts in
    place of them."""
    files = {place: path for place, path in member.delivered if place not in present}
    if not files:
        return summary
    from bringup_lint.discover.layered import copied

    robot = Robot(copied(files), job.config.target_ros, job.config.target_systemd, job.today)
    said, failures = identified(robot, job.key, files)
    return replace(
        summary,
        marks=(*summary.marks, *said.marks),
        facts=(*summary.facts, *said.facts),
        failures=(*summary.failures, *failures),
    )


def tree_of(member: Member, config: Config) -> Tree:
    """Raises OSError or ValueError for an archive that cannot be read."""
    named = [f"{os.path.abspath(layer)}/" for layer in member.layers if os.path.isdir(layer)]
    excluded = exclusion(config.folder, config.exclude, named)
    if len(member.layers) > 1 or not os.path.isdir(member.layers[0]):
        from bringup_lint.discover.layered import layered

        return layered(member.layers, TOPS, excluded)
    folder = os.path.abspath(member.layers[0])
    return discover([folder], deploy=_places(folder), excluded=excluded)


def _names_of(member: Member) -> Callable[[str], str]:
    """What puts the names that archives have on the command line in place of those by which their files are judged."""
    from bringup_lint.discover.layered import top_of

    judged = {display_name(top_of(layer)): display_name(os.path.abspath(layer)) for layer in member.layers}
    names = {short: long for short, long in judged.items() if short != long}
    if not names:
        return str
    written = re.compile(rf"(?<![\w./-])({'|'.join(map(re.escape, names))})/")
    return lambda text: written.sub(lambda found: f"{names[found.group(1)]}/", text)


def _places(folder: str) -> dict[str, str]:
    """Where a snapshot's folders lie on the robot."""
    if os.path.basename(folder) == "etc":
        return {folder: "/etc"}
    return {os.path.join(folder, top): f"/{top}" for top in TOPS if os.path.isdir(os.path.join(folder, top))}


def _own(found: Finding) -> Own:
    place = place_of(found.span)
    return Own(
        found.rule,
        str(found.severity),
        " ".join(found.message.split()),
        found.source.name,
        place.line,
        place.column,
        found.fingerprint,
    )
