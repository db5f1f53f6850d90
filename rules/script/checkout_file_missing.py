"""A script or unit names a file of its own repository that the repository does not have.

## What it finds
Paths below a home folder, `/opt` or `/srv` that lead into the checkout of this very repository, and to what it does not
have, in units, scripts and login files: `WorkingDirectory=`, programs, files that `source`, `cd`, `python3`, `rviz2 -d`
and `ros2 launch` read. Where the checkout is, other paths of the tree say: those that lead to files that exist. It is
info where the path is the value of an argument (`NAME:=PATH`) that a launch file of the tree, with what it includes,
does not read.

Not reported: what builds, downloads and scripts of the tree make, ignored files, submodules, and what is tested for
before it is used.

## Why it matters on a robot
Files are moved, and the paths that units and aliases spell out stay behind: the service ends with 200/CHDIR or
"No such file or directory", and is restarted again and again.

## Bad
```ini
[Service]
WorkingDirectory=/home/pi/rover/backend        # the folder is called server since last year
ExecStart=/home/pi/rover/scripts/start.sh
```

## Good
```ini
[Service]
WorkingDirectory=/home/pi/rover/server
ExecStart=/home/pi/rover/scripts/start.sh
```

## When to ignore it
When people put the file there by hand.

## References
- systemd.exec(5), "WorkingDirectory="; bash(1)
"""

import os
import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

KINDS = ("shell-script", "systemd-unit", "systemd-dropin")
HOME = r"(?:~|\$HOME|\$\{HOME\}|%h|/home/[\w.-]{1,40}|/root)"
PATH = regex(
    rf"(?<![\w.$/~}}])(?:{HOME}(?P<below>(?:/[\w.+@-]{{1,80}}){{2,12}})"
    r"|(?P<whole>/(?:opt|srv|usr/local/src)(?!/ros/)(?:/[\w.+@-]{1,80}){2,12}))/?(?![\w$*{?<%+@/-])"
)
REMARK = regex(r"[ \t]*[#;]")
READS = regex(
    r"(?:(?:^|[\s;&|'\"(=])(?:source|\.|cd|bash|sh|python3?|exec|-d|--params-file)[ \t]{1,4}|:=|launch[ \t]{1,4}"
    r"|^(?:ExecStart\w*|ExecStop|ExecReload|WorkingDirectory|EnvironmentFile)=[@+!:]{0,3}"
    r"|(?:^|&&|;)[ \t]{0,8}|alias [\w-]{1,40}=)[\"']?$"
)
"""What comes right before a path that is read."""
BEFORE = 60
ARGUMENT = regex(r"(?<!\w)(?P<name>\w+):=[\"']?$")
LAUNCHES = regex(
    r"\blaunch[ \t]{1,9}(?:-\S{1,40}[ \t]{1,9}){0,9}(?P<package>\w{1,80})[ \t]{1,9}(?P<file>[\w.-]{1,80})[ \t]"
)
GENERATED = regex(
    r"(?:^|/)(?:install|devel|build|log|logs?|bags?|maps?|data|\.?v?env|node_modules|target|dist|out|output|tmp|certs?|keys?"
    r"|keystore|models?|recordings?|secrets?)$|\.(?:hex|bin|elf|uf2|so|o|a|ko|deb|whl|jar|img|zip|tgz|gz|onnx|engine|tflite"
    r"|pth?|weights|bag|db3|mcap|log|pid|sock|env|pem|key|crt)$"
)
MADE = r"(?:\b(?:mkdir|touch|tee|cp|mv|ln|wget|curl|clone|unzip|tar|rsync|scp|venv|output|record)\b|>|-o[ \t])"
MAKERS = regex(
    r"(?:\.(?:sh|bash|py|ya?ml|cmake|mk|md|rst|repos|j2)|(?:^|/)(?:Makefile|Dockerfile|CMakeLists\.txt)[^/]*)$"
)
MOST = 100_000
MOST_PATHS = 500
"""Paths that are followed; each is looked for in all pages of the tree."""
FOLDER = "src"


@rule(
    "warning",
    confidence="medium",
    symptoms=["status=200/CHDIR"],
)
def checkout_file_missing(robot: Robot) -> Iterator[Finding]:
    if robot.tree.root is not None:
        return
    paths = [each for source in robot.of_kind(*KINDS) if not source.template for each in _paths(source)]
    checkouts = _checkouts(robot, {below for _, below, _ in paths})
    missing: dict[tuple[Source, str, str], list[Located]] = {}
    for word, below, is_read in paths[:MOST_PATHS]:
        checkout = next((each for each in checkouts if below.startswith(f"{each}/")), None)
        if checkout is None or not is_read or not word.span.source.judged:
            continue
        lacking = _lacking(robot, checkouts[checkout], below.removeprefix(f"{checkout}/"))
        if lacking and not _is_tested(word) and robot.filesystem.shipped_sibling(str(word)) is None:
            missing.setdefault((word.span.source, checkout, lacking), []).append(word)
    for (_, checkout, lacking), (word, *others) in missing.items():
        if not _is_made(robot, lacking):
            yield finding(
                word,
                f"There is no {lacking} in {_place(word, checkout)}, which comes from this repository: {_effect(word)}",
                advice="name what the repository has, or add it",
                related=[note(other, "here too") for other in others],
                severity="info" if all(_is_unread(robot, each) for each in (word, *others)) else None,
            )


def _paths(source: Source) -> Iterator[tuple[Located, str, bool]]:
    """The paths below a home folder, with what follows that, and whether something reads them."""
    if not any(
        text in source.text for text in ("/home/", "~", "HOME", "%h", "/root/", "/opt/", "/srv/", "/local/src/")
    ):
        return
    for found in PATH.finditer(source.text):
        start = source.text.rfind("\n", 0, found.start()) + 1
        before = source.text[max(start, found.start() - BEFORE) : found.start()]
        if not REMARK.match(source.text[start : found.start() + 1]):
            yield (
                source.located(*found.span()),
                os.path.normpath(found["below"] or found["whole"]),
                READS.search(before) is not None,
            )


def _checkouts(robot: Robot, belows: Iterable[str]) -> dict[str, tuple[str, ...]]:
    """The folders in which this repository or a package of it surely lies on the robot, each with the folders here
    that are meant; the longest first."""
    tops = tuple(dict.fromkeys((*robot.tree.tops, *robot.tree.asked)))
    packages = _packages(robot)
    shown: dict[str, set[str]] = {}
    found: dict[str, tuple[str, ...]] = {}
    for below in belows:
        parts = below.split("/")
        for at in range(2, len(parts)):
            inner, outer = "/".join(parts[at:]), "/".join(parts[:at])
            if _has(robot, tops, inner):
                shown.setdefault(outer, set()).add(inner)
            if FOLDER in parts[2 : at - 1] and parts[at - 1] in packages:
                found[outer] = (packages[parts[at - 1]],)
    found.update({each: tops for each, inner in shown.items() if _is_sure(robot, tops, each, inner)})
    return dict(sorted(found.items(), key=lambda item: len(item[0]), reverse=True))


def _packages(robot: Robot) -> dict[str, str]:
    """The folders of packages whose name no other folder of a package has."""
    found: dict[str, set[str]] = {}
    for path in robot.tree.named("package.xml"):
        folder = os.path.dirname(os.path.abspath(path))
        found.setdefault(os.path.basename(folder), set()).add(folder)
    return {name: next(iter(folders)) for name, folders in found.items() if len(folders) == 1}


def _is_sure(robot: Robot, tops: tuple[str, ...], checkout: str, inner: set[str]) -> bool:
    name = os.path.basename(checkout)
    if _has(robot, tops, name):
        return False
    return any(os.path.basename(top).endswith(name) for top in tops) or sum("/" in each for each in inner) > 1


def _has(robot: Robot, tops: tuple[str, ...], inner: str) -> bool:
    return any(robot.tree.exists(f"{top}/{inner}") for top in tops)


def _lacking(robot: Robot, tops: tuple[str, ...], inner: str) -> str:
    """The first folder or file on the way to a path that the repository does not have; empty where it may."""
    parts = inner.split("/")
    for at in range(1, len(parts) + 1):
        path = "/".join(parts[:at])
        if not _has(robot, tops, path):
            is_of_others = at > 1 and parts[at - 2] == FOLDER
            return "" if is_of_others or any(_may_appear(robot, f"{top}/{path}") for top in tops) else path
    return ""


def _may_appear(robot: Robot, path: str) -> bool:
    tree = robot.tree
    if GENERATED.search(path) or tree.is_ignored(path) or tree.matches(f"{path}.*"):
        return True
    return any(f"{path}/".startswith(f"{each}/") for each in tree.submodules)


def _is_tested(word: Located) -> bool:
    """Whether the file looks first whether the path is there."""
    text = word.span.source.text
    return re.search(rf"(?:\[|\btest)[ \t]+(?:![ \t]+)?-[defrsx][ \t]+[\"']?{re.escape(word)}", text) is not None


def _is_made(robot: Robot, lacking: str) -> bool:
    """Whether something of the tree may make it."""
    name = re.escape(os.path.basename(lacking))
    made = re.compile(rf"{MADE}[^\n]{{0,200}}(?<![\w.-]){name}(?![\w.-])")
    return any(map(made.search, robot.tree.pages(MAKERS, MOST)))


def _place(word: Located, checkout: str) -> str:
    """The folder of the checkout as people write it."""
    return checkout if word.startswith(f"{checkout}/") else f"~{checkout}"


def _is_unread(robot: Robot, word: Located) -> bool:
    """Whether a path is the value of an argument which the launch file that gets it does not read, nor what this
    includes."""
    before = word.span.source.line_before(word.span.start)
    argument, command = ARGUMENT.search(before), next(iter([*LAUNCHES.finditer(before)][-1:]), None)
    file = robot.launch.named(command["package"], command["file"]) if argument and command else None
    if argument is None or file is None:
        return False
    from bringup_lint.api.launch import unread_arguments  # a script that launches nothing does not need it

    name, started = argument["name"], robot.launch.expansion(file)
    if any(each.declared.name == name for each in unread_arguments(robot.launch, file)):
        return True
    is_known = not started.opaque and not started.is_lost and name not in started.outside
    return is_known and not any(each.reads_all or robot.launch.mentions(each, name) for each in started.files)


def _effect(word: Located) -> str:
    source = word.span.source
    line = source.text[source.text.rfind("\n", 0, word.span.start) + 1 : word.span.start]
    if line.startswith("WorkingDirectory="):
        return "the service does not start, 200/CHDIR"
    if ARGUMENT.search(line):
        return "this argument leads nowhere"
    return "what reads it fails"
