"""A script enables or starts a unit that nothing installs.

## What it finds
`systemctl enable`, `reenable`, `start` and `restart`, and tasks of Ansible's systemd and service modules, of a unit
that looks like one of the robot's own (the same first word as another unit of the tree, nearly the name or the end of
one, that of a template without an instance, or that of a package of the workspace where robot_upstart makes no unit of
it) and that neither a file of the tree nor a script provides. Also a template of the tree that is named without an
instance (`rover@.service`) and has no `DefaultInstance=`.

Not reported: units of Debian and Ubuntu, names that a variable gives, and commands whose failure is expected (`||`,
`2>/dev/null`, `if systemctl ...`).

## Why it matters on a robot
systemctl ends with "Unit file does not exist". With `set -e` the set-up stops in the middle, and without it the message
scrolls past: after the next boot the unit that was meant does not run.

## Bad
```sh
cp rover-base.service /etc/systemd/system/
systemctl enable --now rover-bringup.service    # the unit is called rover-base.service
```

## Good
```sh
cp rover-base.service /etc/systemd/system/
systemctl enable --now rover-base.service
```

## When to ignore it
When a package or another repository installs the unit.

## References
- systemctl(1), "enable" and "start"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run
from bringup_lint.api.shell import Task
from bringup_lint.api.shell import tasks
from bringup_lint.api.systemd import Unit
from bringup_lint.api.yaml import Mapping

VERBS = ("enable", "reenable", "start", "restart")
VALUED = ("-H", "--host", "-M", "--machine", "-t", "--type", "-p", "--property", "--root", "-n", "--lines")
PLAIN = regex(r"[\w.@:\\-]+")
TYPED = regex(r"\.(?:service|target|timer|socket|path|mount|automount|slice|swap|device|scope)$")
MODULES = ("systemd", "systemd_service", "service")
MOST = 20
MAKERS = regex(r"\brobot_upstart\b", hints="robot_upstart")
"""Makes units of launch files, which have the names of their packages."""

OF_DEBIAN = regex(r"(?:^|/)debian/[^/]+\.service$", hints="debian/")
"""Units that dh_installsystemd installs, with the name of their package before their own."""


class Named(NamedTuple):
    """A unit that a command names."""

    word: Located
    verb: str
    name: str
    manager: str
    command: str = "systemctl"


@rule(
    "warning",
    confidence="medium",
    symptoms=[
        "Failed to enable unit: Unit file * does not exist.",
        "destination unit * is a non-template unit",
        "is missing the instance name",
        "Failed to start *: Unit * not found.",
    ],
)
def unit_missing(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[Source, str], list[Named]] = {}
    for source, run in robot.scripts.run("systemctl"):
        for named in _named(run):
            template = _template(robot, named)
            if template is not None and "DefaultInstance" not in source.text:
                yield finding(
                    named.word,
                    f"systemctl {named.verb} fails: {named.name} is a template, and no instance is named",
                    advice=f"give the instance, for example {named.name.replace('@', '@1')}, or set DefaultInstance=",
                    related=[note(template.where, "the template")],
                )
            is_lacking = robot.units.lacks(named.name, named.manager) or _is_of_package(robot, named)
            if is_lacking and not robot.scripts.brings_unit(source, named.name):
                found.setdefault((source, named.name), []).append(named)
    bringing: list[tuple[str, str]] | None = None
    for source, named in _of_plays(robot):
        if robot.units.lacks(named.name, "system"):
            if bringing is None:
                bringing = _bringing(robot)
            if _is_brought(bringing, named.name):
                continue
            found.setdefault((source, named.name), []).append(named)
    for first, *others in found.values():
        like = robot.units.like(first.name, first.manager)
        yield finding(
            first.word,
            f"{first.command} {first.verb}".rstrip() + f" fails: nothing in this tree installs {first.name}",
            advice=_advice(like),
            related=[
                *(note(other.word, f"systemctl {other.verb} fails, too") for other in others[:MOST]),
                *(note(unit.where, "a unit that the tree has") for unit in like[:2]),
            ],
        )


def _is_of_package(robot: Robot, named: Named) -> bool:
    """Whether a command names the unit of a package of the workspace, in a tree that has other units and not this."""
    name = named.name.removesuffix(".service")
    units = robot.units
    if name == named.name or not robot.has_launch_files or name not in robot.launch.workspace.packages:
        return False
    if units.candidates(named.name, named.manager) or units.is_made_by_script(named.name):
        return False
    if any(".service" in build.source.text for build in robot.launch.workspace.packages[name].builds):
        return False
    if any(path.endswith(f".{named.name}") for path in robot.tree.like(OF_DEBIAN)):
        return False
    own = (unit for unit in units.all if unit.fragment is not None and unit.manager == named.manager)
    return any(robot.same_robot(named.word, unit.where.source) for unit in own) and not robot.mentions(MAKERS)


def _template(robot: Robot, named: Named) -> Unit | None:
    """The template of the tree that a command names without an instance, where it has no default."""
    if "@." not in named.name:
        return None
    candidates = list(robot.units.candidates(named.name, named.manager))
    if any(unit.has("DefaultInstance", "Install") for unit in candidates):
        return None
    for unit in candidates:
        wanted = [*unit.words("WantedBy", "Install"), *unit.words("RequiredBy", "Install")]
        needs = named.verb not in ("enable", "reenable") or (wanted and not any("@" in word for word in wanted))
        if needs and unit.fragment is not None and not unit.uncertain:
            return unit
    return None


def _of_plays(robot: Robot) -> Iterator[tuple[Source, Named]]:
    """The units that tasks of Ansible enable or start, each by a name of their own or by the items of a loop."""
    for source in robot.of_kind("ansible"):
        if not source.judged or not any(f"{each}:" in source.text for each in MODULES):
            continue
        for task in tasks(source):
            for module, settings in task.modules:
                if module.rpartition(".")[2] in MODULES and isinstance(settings, Mapping) and not task.may_fail:
                    yield from ((source, each) for each in _of_task(task, settings))


def _of_task(task: Task, settings: Mapping) -> Iterator[Named]:
    name, state, enabled = (settings.scalar(key) for key in ("name", "state", "enabled"))
    wanted = (state is not None and state.value in ("started", "restarted")) or (
        enabled is not None and enabled.boolean
    )
    if name is None or not wanted or settings.get("scope") is not None or task.conditional:
        return
    loop = task.keys.sequence("loop") or task.keys.sequence("with_items")
    words = [each.value for each in loop.scalars] if loop and name.value == "{{ item }}" else [name.value]
    for word in words:
        if PLAIN.fullmatch(word):
            yield Named(word, "", word if TYPED.search(word) else f"{word}.service", "system", "This task")


INSTALLS = r"\b(?:apt|deb|package|pip|snap|dnf|yum|command|shell|script|get_url|unarchive)\b|\.(?:sh|py|deb)\b"

FILE = regex(r"\.(?:service|timer|target|socket)")
INSTALLING = regex(INSTALLS)


def _bringing(robot: Robot) -> list[tuple[str, str]]:
    """The lines of each play that name units by their files, and those that install something."""
    texts = [each.text for each in robot.of_kind("ansible", "ansible-vars")]
    return [
        ("\n".join(filter(FILE.search, lines)), "\n".join(filter(INSTALLING.search, lines)))
        for lines in map(str.splitlines, texts)
    ]


def _is_brought(bringing: list[tuple[str, str]], name: str) -> bool:
    """Whether something else in the plays of the tree has to do with a file of that name."""
    plain = name.rpartition(".")[0].partition("@")[0]
    stem = re.escape(plain)
    file = re.compile(rf"(?:/|(?:src|dest):[^\n]{{0,400}}){stem}(?:@[\w{{}} ]*)?\.(?:service|timer|target|socket)")
    package = re.compile(rf"^(?![ \t]*(?:- )?name:)[^\n#]*(?:{INSTALLS})[^\n]*\b{stem}\b", re.M)
    return any(
        (plain in files and file.search(files)) or (plain in installs and package.search(installs))
        for files, installs in bringing
    )


def _advice(like: list[Unit]) -> str:
    if len(like) != 1:
        return "correct the name, or install the unit before"
    if like[0].is_template:
        return f"{like[0].name} is a template: give the instance, for example {like[0].name.replace('@', '@1')}"
    return f"did you mean {like[0].name}?"


def _named(run: Run) -> Iterator[Named]:
    """The units that a command needs, where nothing shows that it may fail."""
    if run.command.ends in ("||", "&&", "|") or run.command.hides_errors:
        return
    words = [word for at, word in enumerate(run.words) if at and run.words[at - 1] not in VALUED]
    plain = [word for word in words if not word.startswith("-")]
    if not plain or plain[0] not in VERBS or any(word.startswith(("--root", "-H", "-M")) for word in words):
        return
    manager = "user" if "--user" in words else "system"
    for word in plain[1:]:
        text = run.text(word)
        if PLAIN.fullmatch(text):
            yield Named(word, str(plain[0]), text if TYPED.search(text) else f"{text}.service", manager)
