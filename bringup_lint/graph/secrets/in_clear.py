"""Secrets in clear text: where a name or a value tells that a password, key or token stands in a file."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.secrets.programs import assigned
from bringup_lint.graph.secrets.ros import Indirect
from bringup_lint.graph.secrets.ros import indirect
from bringup_lint.graph.secrets.ros import launch_words
from bringup_lint.graph.secrets.ros import named_values
from bringup_lint.parsers.env_file import parse
from bringup_lint.parsers.systemd_values import split_environment
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.templates import has_placeholder
from bringup_lint.templates import is_example
from bringup_lint.templates import is_stand_in

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

_NAME = re.compile(
    r"(?:^|[_-])(?:pass(?:word|wd|phrase|code)?|pwd|secret|token|credentials?|psk|"
    r"(?:api|access|secret|private|auth|account|encryption|signing|shared|license)[_-]?key)(?:[_-]?\d+|[_-]value)?$",
    re.I,
)
_NO_NAME = re.compile(r"^(?:old)?pwd$", re.I)
_KNOWN_VALUE = re.compile(
    r"\b(?:AKIA|ASIA)[0-9A-Z]{16}\b|\bgh[pousr]_[A-Za-z0-9]{30,}|\bgithub_pat_\w{30,}|\bglpat-[\w-]{20}"
    r"|\bsk[-_]live[-_]\w{16,}|\bxox[abprs]-[\w-]{20,}|-----BEGIN (?:[A-Z]+ )*PRIVATE KEY-----"
    r"|\beyJ[\w-]{10,}\.eyJ[\w-]{10,}\.[\w-]{10,}"
)
_USER_INFO = re.compile(r"\b[a-z][a-z0-9+.-]*://[^/\s:@]+:([^@/\s]+)@")
_NO_VALUE = re.compile(
    r"[/~]|\$|%|file:|env:|true$|false$|yes$|no$|on$|off$|\d{1,5}$|.*\.(?:pem|key|crt|cer|p12|env|json|ya?ml|txt)$",
    re.I,
)
_WEAK = re.compile(r"(?:change[-_ ]?me|password|passwd|secret|admin|default|test|example|xxx+|foo|bar)\d*$", re.I)
_OPTION = re.compile(r"--([A-Za-z][\w-]*)(?:=(.*))?$", re.S)
_SAMPLE = re.compile(
    r"_(?:example|sample|template)s?\.|[.-](?:example|sample|template|dist|tmpl|default)s?(?:$|\.)|^(?:example|sample)",
    re.I,
)


class Secret(NamedTuple):
    """A value that should not be readable here."""

    value: Located
    name: str
    """What it is called: a variable, an option."""
    holder: str
    """``unit``, ``command``, ``env-file``, ``compose``, ``image``, ``params``, ``launch`` or ``program``."""
    weak: bool
    """A well-known stand-in such as ``changeme``, which nevertheless works as a password."""
    sample: bool
    """A sample of a documentation, by its own word (it ends in EXAMPLE), or an account for everybody."""


def secrets(robot: Robot) -> Iterator[Secret]:
    """Every secret of the judged units, environment, compose, parameter and launch files, Dockerfiles and programs,
    each place once."""
    seen: set[tuple[int, int]] = set()
    holders = (_of_units, _of_env_files, _of_compose, _of_images, _of_ros, _of_programs)
    for found in (found for holder in holders for found in holder(robot)):
        source = found.value.span.source
        place = (id(source), found.value.span.start)
        if place in seen or not source.judged or _SAMPLE.search(source.basename) or is_example(source.name):
            continue
        seen.add(place)
        yield found


def secret(name: str, value: Located, holder: str) -> Secret | None:
    """The secret that a value is, by its name or its form; None when it is none."""
    known = _KNOWN_VALUE.search(value) or _USER_INFO.search(value)
    if known:
        group = 1 if known.re is _USER_INFO else 0
        part = value.part(*known.span(group))
    elif value and _NAME.search(name) and not _NO_NAME.match(name):
        part = value
    else:
        return None
    weak = _WEAK.match(part) is not None
    if not weak and (_NO_VALUE.match(part) or is_stand_in(part) or has_placeholder(part)):
        return None
    return Secret(part, name, holder, weak, part.upper().endswith("EXAMPLE"))


def _of_units(robot: Robot) -> Iterator[Secret]:
    for unit in robot.units.judged:
        for value in unit.values("Environment", unit.section):
            for variable in split_environment(value) if not unit.is_opaque(value) else ():
                yield from _one(secret(variable.name, variable.value, "unit"))
        for process in robot.units.processes(unit) if unit.type == "service" else ():
            for step in process.steps:
                if step.script is None:
                    yield from _of_words(step.command.assignments, step.command.words)


def _of_words(assignments: tuple[Located, ...], words: tuple[Located, ...]) -> Iterator[Secret]:
    for word in (*assignments, *words):
        name, equals, _ = word.partition("=")
        if equals and re.fullmatch(r"[A-Za-z_]\w*", name):
            yield from _one(secret(name, word.part(len(name) + 1, len(word)), "command"))
    for at, word in enumerate(words):
        option = _OPTION.fullmatch(word)
        if option and option[2] is not None:
            yield from _one(secret(option[1], word.part(option.start(2), len(word)), "command"))
        elif option and at + 1 < len(words) and not words[at + 1].startswith("-"):
            yield from _one(secret(option[1], words[at + 1], "command"))


def _of_env_files(robot: Robot) -> Iterator[Secret]:
    sources = {id(source): source for source in robot.of_kind("env-file")}
    for unit in robot.units.judged:
        found = (file.source for file in robot.units.environment_files(unit) if file.source)
        sources |= {id(source): source for source in found}
    readable = [source for source in sources.values() if not is_private(source)]
    for model in robot.parsed(parse, readable):
        for entry in model.entries:
            yield from _one(secret(entry.name, entry.value, "env-file"))


def is_private(source: Source) -> bool:
    """Whether only the owner and a group may read the file, as its real permissions say."""
    return source.mode is not None and not source.mode & 0o007


def _of_compose(robot: Robot) -> Iterator[Secret]:
    for service in robot.compose.services if robot.of_kind("compose") else ():
        for name, variable in service.environment.items():
            if variable.value is not None:
                yield from _one(secret(name, variable.value, "compose"))


def _of_images(robot: Robot) -> Iterator[Secret]:
    for file in robot.dockerfiles:
        for instruction in file.instructions:
            if instruction.name in ("ENV", "ARG"):
                for word in instruction.value.words():
                    name, equals, _ = word.partition("=")
                    if equals:
                        value = word.part(len(name) + 1, len(word)).strip_located("\"'")
                        yield from _one(secret(name, value, "image"))


def _of_ros(robot: Robot) -> Iterator[Secret]:
    for each in named_values(robot):
        found = secret(each.name, each.value, each.holder)
        if found is not None:
            yield found._replace(sample=True) if each.public else found
    for words in launch_words(robot):
        for found in _of_words((), words):
            yield found._replace(holder="launch")


def _of_programs(robot: Robot) -> Iterator[Secret]:
    for each in assigned(robot):
        found = secret(each.name, each.value, "program")
        if found is not None and not found.weak:
            yield found


def exposed(robot: Robot) -> Iterator[Indirect]:
    """Parameters with the name of a secret that are filled from the environment or from arguments."""
    for each in indirect(robot):
        source = each.where.source
        if (
            _NAME.search(each.name)
            and source.judged
            and not is_example(source.name)
            and not _SAMPLE.search(source.basename)
        ):
            yield each


def _one(found: Secret | None) -> Iterator[Secret]:
    if found is not None:
        yield found
