"""A script sets a variable of ROS that the programs it starts do not see.

## What it finds
`ROS_DOMAIN_ID=7` and the like on a line of its own, without `export`, in a script that runs `ros2` afterwards, where
neither the script nor any other file of the tree names the variable a second time. Silent under `set -a`.

Also such a line after an `unset` of the variable, in a script that neither exports nor reads it: after `unset`, a
variable that was exported is exported no more.

Also a file of variables that a script sources before `ros2 launch`, when the launch file reads variables and the script
exports none of these. It is one that a unit reads with `EnvironmentFile=`, where nothing may be exported, or one of the
tree that sets a variable of the launch file.

## Why it matters on a robot
The shell keeps the variable to itself. The nodes start with the default domain, the default middleware and without the
file of settings, and nothing says so.

## Bad
```sh
ROS_DOMAIN_ID=7
ros2 launch rover_bringup rover.launch.py
```

## Good
```sh
export ROS_DOMAIN_ID=7
ros2 launch rover_bringup rover.launch.py
```

## When to ignore it
When whoever starts the script has exported the variable, which then keeps being exported, or whoever sources it exports
the variable afterwards.

## References
- bash(1), "ENVIRONMENT"
"""

import re
from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

NAME = regex(
    r"(?:ROS_(?:DOMAIN_ID|LOCALHOST_ONLY|AUTOMATIC_DISCOVERY_RANGE|STATIC_PEERS|DISCOVERY_SERVER|SUPER_CLIENT|LOG_DIR|HOME"
    r"|SECURITY_\w+)|RMW_\w+|CYCLONEDDS_URI|FAST(?:RTPS|DDS)_DEFAULT_PROFILES_FILE|RCUTILS_\w+)(?==)"
)
NAMED = regex(r"\b(?:ROS|RMW|RCUTILS|CYCLONEDDS|FASTRTPS|FASTDDS)_[A-Z0-9_]+\b")
READ = regex(
    r"(?:environ\.get\(|environ\[|getenv\(|(?<!Set)EnvironmentVariable\(|\$\((?:opt)?env )\s{0,9}[\"']?"
    r"(?P<name>[A-Z][A-Z0-9_]+)",
    hints="environ getenv EnvironmentVariable env",
)
"""What of the environment a launch file reads."""
SETUP = regex(r"setup\.\w+$|\.bashrc$|activate$")
SOURCES = regex(r"^[ \t]*(?:source|\.)[ \t]", re.M)
EXPORT, WORD = regex(r"\b(?:export|declare[ \t]+-x|typeset[ \t]+-x)\b([^\n]*)"), regex(r"\w+")
UNSETS = regex(r"^[ \t]*unset[ \t]", re.M, "unset")
READS = regex(r"\$\{?([A-Z][A-Z0-9_]+)")
EXPORTED = regex(r"^[ \t]*export\b", re.M)
EXPORTS_ALL = regex(r"^[ \t]*set[ \t]+(?:-[a-z]{0,8}a[a-z]{0,8}\b|-o[ \t]+allexport)", re.M)


@rule("warning", confidence="medium", silent="the nodes start with their defaults")
def not_exported(robot: Robot) -> Iterator[Finding]:
    starts = list(_starts(robot))
    named = _named(robot) if starts else Counter()
    for source, kept, started in starts:
        own = Counter(NAMED.findall(source.text))
        lost = [word for word in kept if _is_lost(word, started, named, own)]
        if lost:
            first, *others = lost
            yield finding(
                first,
                f"{first.partition('=')[0]} is not exported: ros2 and its nodes do not see it",
                advice="write export before it",
                related=[
                    note(started, "started without it"),
                    *(note(other, "is not exported, either") for other in others),
                ],
            )
    yield from _unset_before(robot)
    yield from _sourced_files(robot)


def _unset_before(robot: Robot) -> Iterator[Finding]:
    """Variables that a script has unset, sets again, and neither exports nor reads."""
    for source in robot.of_kind("shell-script"):
        if not source.judged or not UNSETS.search(source.said) or EXPORTS_ALL.search(source.said):
            continue
        used = {name for line in EXPORT.findall(source.said) for name in WORD.findall(line)}
        used.update(READS.findall(source.said))
        unset: dict[str, Located] = {}
        for run in robot.scripts.done(source):
            if not isinstance(run, Run) or not run.certain:
                continue
            if run.name == "unset":
                unset.update((str(word), word) for word in run.words[1:])
            if run.words:
                continue
            for word in _kept(run):
                name = word.partition("=")[0]
                if name in unset and name not in used:
                    yield finding(
                        word,
                        f"{name} is no longer exported after unset: ros2 and its nodes do not see this value",
                        advice="write export before it",
                        related=[note(unset[name], "unset here")],
                    )


class Unseen(NamedTuple):
    """A file of variables that a script sources, and what the launch file reads and the script does not export."""

    path: Located
    names: dict[str, Span]
    """Variable -> where it is read."""


def _sourced_files(robot: Robot) -> Iterator[Finding]:
    """Files of variables that a script sources, and that do not reach what its launch file reads."""
    found = [each for source in robot.of_kind("shell-script") for each in _unseen(robot, source)]
    of_units = _of_units(robot) if found else frozenset()
    for each in found:
        entries = _entries(robot, each.path)
        known = [name for name in each.names if name in entries or (not entries and str(each.path) in of_units)]
        if known:
            yield finding(
                each.path,
                f"What this file sets is not exported: the launch file does not see {', '.join(known[:3])}",
                advice="write set -a before it, and set +a after it",
                related=[note(each.names[name], f"reads {name}") for name in known[:5]],
            )


def _unseen(robot: Robot, source: Source) -> Iterator[Unseen]:
    text = source.text
    if "ros2" not in text or not SOURCES.search(text) or EXPORTS_ALL.search(text):
        return
    exported = {name for line in EXPORT.findall(text) for name in WORD.findall(line)}
    for launching in robot.runners.launched_by(source):
        expansion = robot.runners.expansion(launching.start)
        files = [file.source for file in expansion.files] if expansion is not None else []
        wanted = {match["name"]: each.span(*match.span("name")) for each in files for match in READ.finditer(each.text)}
        lost = {name: place for name, place in wanted.items() if name not in exported}
        if lost:
            yield from (Unseen(path, lost) for path in _files(robot, source, launching.target))


def _of_units(robot: Robot) -> frozenset[str]:
    """The paths that units read as EnvironmentFile=."""
    units = robot.units
    return frozenset(each.path for unit in units.judged for each in units.environment_files(unit) if each.path)


def _files(robot: Robot, source: Source, before: Located) -> Iterator[Located]:
    """The files that a script sources before it starts something."""
    for did in robot.scripts.done(source):
        if isinstance(did, Run) and did.name in ("source", ".") and len(did.words) > 1:
            if did.words[1].span.start < before.span.start and not SETUP.search(did.words[1]):
                yield did.words[1]


def _entries(robot: Robot, path: Located) -> dict[str, Located]:
    """The variables of a file of the tree, where it exports none."""
    found = robot.environment_file(str(path)) if path.startswith("/") else None
    if found is None or EXPORTED.search(found.source.text):
        return {}
    return {str(entry.name): entry.value for entry in found.entries}


def _starts(robot: Robot) -> Iterator[tuple[Source, list[Located], Located]]:
    """Script, the assignments that it keeps to itself, and where it starts ros2."""
    for source in robot.of_kind("shell-script"):
        if not source.judged or "ros2" not in source.text or EXPORTS_ALL.search(source.text):
            continue
        runs = [did for did in robot.scripts.done(source) if isinstance(did, Run)]
        kept = [word for run in runs if not run.words for word in _kept(run)]
        started = next((run.words[0] for run in runs if run.name == "ros2" and run.certain), None)
        if kept and started is not None:
            yield source, kept, started


def _kept(run: Run) -> Iterator[Located]:
    return (word for word in run.command.assignments if NAME.match(word))


def _named(robot: Robot) -> Counter[str]:
    """Variable -> how many files name it."""
    return Counter(name for source in robot.sources for name in set(NAMED.findall(source.text)))


def _is_lost(word: Located, started: Located, named: Counter[str], own: Counter[str]) -> bool:
    """Whether only this line names the variable, and it is before the start."""
    name = word.partition("=")[0]
    return word.span.start < started.span.start and named[name] == own[name] == 1
