"""Secrets in clear text: where a name or a value shows that a password, key or token is in a file."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Set as AbstractSet

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.graph.secrets.passwords import Password
from bringup_lint.graph.secrets.passwords import given_to_programs
from bringup_lint.graph.secrets.passwords import in_images
from bringup_lint.graph.secrets.passwords import in_variables
from bringup_lint.graph.secrets.passwords import in_wifi_files
from bringup_lint.graph.secrets.programs import assigned
from bringup_lint.graph.secrets.ros import Indirect
from bringup_lint.graph.secrets.ros import indirect
from bringup_lint.graph.secrets.ros import launch_words
from bringup_lint.graph.secrets.ros import named_values
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.env_file import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Origin
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.templates import has_placeholder
from bringup_lint.templates import is_example
from bringup_lint.templates import is_named_template
from bringup_lint.templates import is_stand_in
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.installed.script import Written
    from bringup_lint.graph.installed.scripts import Scripts
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.dockerfile import Dockerfile

_NAME = regex(
    r"(?:^|[._-])(?:pass(?:word|wd|phrase|code)?|pwd|secret|token|credentials?|psk|"
    r"(?:api|access|secret|private|auth|account|encryption|signing|shared|license)[_-]?key)(?:[_-]?\d+|[_-]value)?$",
    re.I,
)
_NO_NAME = regex(
    r"^(?:(?:old)?pwd|(?:fastcgi|grpc|proxy|scgi|uwsgi)_pass|KAFKA_(?:SASL|SSL)_\w*CREDENTIALS|MINIO_ACCESS_KEY|"
    r"(?:.*[._-])?(?:max|min|num)[._-]?token)$",
    re.I,
)
"""Also the addresses of nginx, the names of the files that hold the passwords of Kafka, a user of MinIO, and how long
the answer of a language model may be."""
_QUOTED = regex(r"[\"'](.*)[\"']$", re.S)
"""With quotes that whoever sets the variable keeps."""
_KNOWN_VALUE = regex(
    r"\b(?:AKIA|ASIA)[0-9A-Z]{16}\b|\bgh[pousr]_[A-Za-z0-9]{30,}|\bgithub_pat_\w{30,}|\bglpat-[\w-]{20}"
    r"|\bsk[-_]live[-_]\w{16,}|\bxox[abprs]-[\w-]{20,}|-----BEGIN (?:[A-Z]+ )*PRIVATE KEY-----"
    r"|https://(?:\w+\.)?discord(?:app)?\.com/api/webhooks/\d{15,20}/[\w-]{40,}"
    r"|https://hooks\.slack\.com/services/T\w{5,}/B\w{5,}/\w{16,}|\b\d{8,10}:AA[\w-]{33}\b"
    r"|\beyJ[\w-]{10,}\.eyJ[\w-]{10,}\.[\w-]{10,}"
)
_TOKEN = regex(r"\b(?:AKIA[0-9A-Z]{16}|gh[pousr]_[A-Za-z0-9]{36}|github_pat_\w{80,}|glpat-[\w-]{20})(?![\w-])")
"""Those that nothing else looks like, in a file of any kind."""
_SETTINGS = regex(r"(?<!CMakeLists)\.(?:txt|conf|cfg|ini|properties)$")
_MOST_OF_SETTINGS = 64 * 1024
_USER_INFO = regex(r"\b[a-z][a-z0-9+.-]*://[^/\s:@]+:([^@/\s]+)@")
_NO_VALUE = regex(
    r"$|[/~]|\#\s|\$|%|[\"']{2}$|file:|env:|true$|false$|yes$|no$|on$|off$|\d{1,5}$|.*\.(?:pem|key|crt|cer|p12|env|json|ya?ml|txt)$",
    re.I,
)
_WEAK = regex(r"(?:change[-_ ]?me|password|passwd|secret|admin|default|test|example|xxx+|foo|bar|abc)\d*$", re.I)
_DUMMY = regex(r"(?:xxx+|foo|bar|abc|example)\d*", re.I)
_PLACEHOLDER = regex(r"(?:xxx+|foo|bar|abc|test|example|.{1,3})\d*", re.I)
"""The default of a launch argument that nobody takes for a password."""
_OPTION = regex(r"--([A-Za-z][\w.-]*)(?:=(.*))?$", re.S, "--")
_SETTING = regex(
    r"^[ \t]*(?P<name>[\w-]*(?:password|passwd|passphrase|psk|secret|token))[ \t]*[=:][ \t]*"
    r"[\"']?(?P<value>[^\s\"']{3,})"
    r"[\"']?[ \t]*$",
    re.M | re.I,
)
"""A line of a configuration file that sets a password."""
_ASSIGNMENT = regex(r"(?<![\w.-])(?P<name>[\w.-]+)[\"']?[ \t]*[=:][ \t]*[\"']?(?P<value>[^\"'\s.][^\"'\n]*)")
HOLDERS = {
    RunnerKind.UNIT: "unit",
    RunnerKind.SERVICE: "compose",
    RunnerKind.IMAGE: "image",
}
"""Who holds the variables of a runner; of all others, its file."""
_COMMANDS = {RunnerKind.UNIT: "command"}


class Secret(NamedTuple):
    """A value that should not be readable here."""

    value: Located
    name: str
    """What it is called: a variable, an option."""
    holder: str
    """``unit``, ``command`` (of a unit), ``process`` (another command line), ``env-file``, ``compose``, ``image``,
    ``file``, ``params``, ``launch`` or ``program``."""
    weak: bool
    """A well-known stand-in such as ``changeme``, which nevertheless works as a password."""
    sample: bool
    """A sample of a documentation, by its own word (it ends in EXAMPLE), an account for everybody, or one of a
    container on the computer that runs Ansible."""


@dataclass(frozen=True, eq=False)
class Secrets:
    """The secrets of a tree. Layers are asked only where the tree holds a file of their kinds."""

    files: Files
    runners: Runners
    units: Callable[[], Units]
    dockerfiles: Callable[[], list[Dockerfile]]
    launch: Callable[[], Launch]
    params: Callable[[], Params]
    scripts: Callable[[], Scripts]

    def in_clear(self) -> Iterator[Secret]:
        """Every secret of the judged files, each place once."""
        seen: set[Span] = set()
        for found in self._all():
            span = found.value.span
            place = Span(span.source, span.start, span.start)
            if place in seen or not _is_real(span.source):
                continue
            seen.add(place)
            yield found

    def exposed(self) -> Iterator[Indirect]:
        """Parameters with the name of a secret that are filled from the environment or from arguments."""
        found = indirect(self.files, self.launch, self.params)
        return (each for each in found if _NAME.search(each.name) and _is_real(each.where.source))

    def _all(self) -> Iterator[Secret]:
        if dockerfiles := self.dockerfiles():
            yield from _of_images(dockerfiles)
        for runner in self.runners.all:
            yield from _of_environment(runner)
            yield from _of_commands(runner)
        if self.files.of_kind("systemd-unit", "systemd-dropin"):
            yield from _of_other_units(self.units())
        yield from self._of_env_files()
        yield from self._of_ros()
        yield from _of_programs(self.files)
        if self.files.of_kind("shell-script"):
            joined = {source.origin.whole for source in self.files.sources if source.origin is not None}
            yield from _of_written(self.scripts(), joined)
        yield from self._passwords()
        yield from self._tokens()

    def _tokens(self) -> Iterator[Secret]:
        """The tokens of services in files of settings that are of no kind."""
        tree = self.files.tree
        for path in tree.like(_SETTINGS):
            source = tree.at(path) if _TOKEN.search(tree.head(path, _MOST_OF_SETTINGS)) else None
            if source is not None:
                yield from _in_settings(source)

    def _passwords(self) -> Iterator[Secret]:
        for password in in_wifi_files(self.files):
            yield from _one(_of_password(password, "file"))
        for password in in_variables(self.files):
            found = secret(password.name, password.value, "file")
            if found is not None:
                yield found._replace(sample=found.sample or password.local)
        for password in given_to_programs(self.files):
            yield from _one(_of_password(password, "program"))
        for password in in_images(self.files):
            yield from _one(_of_password(password, "image"))

    def _of_env_files(self) -> Iterator[Secret]:
        sources = dict.fromkeys(self.files.of_kind("env-file"))
        for runner in self.runners.all:
            sources |= dict.fromkeys(source for _, source in runner.environment_files)
        for model in self.files.parsed(parse, (source for source in sources if not is_private(source))):
            for entry in model.entries:
                yield from _one(secret(entry.name, entry.value, "env-file"))

    def _of_ros(self) -> Iterator[Secret]:
        for each in named_values(self.files, self.launch, self.params):
            found = secret(each.name, each.value, each.holder)
            if found is not None:
                yield found._replace(sample=True) if each.public else found
        for words in launch_words(self.files, self.launch):
            yield from _of_words((), words, "launch")


def _is_real(source: Source) -> bool:
    """Whether findings may be about a file, and it is no sample."""
    return source.judged and not source.once(_is_sample, lambda: _is_sample(source))


def _is_sample(source: Source) -> bool:
    return is_named_template(source.basename) or is_example(source.name)


def secret(name: str, value: Located, holder: str) -> Secret | None:
    """The secret that a value is, by its name or its form; None when it is none."""
    known = _KNOWN_VALUE.search(value)
    in_address = _USER_INFO.search(value)
    if known:
        part = value.part(*known.span())
    elif in_address:
        part = value.part(*in_address.span(1))
    elif value and _NAME.search(name) and not _NO_NAME.match(name):
        part = value
    else:
        return None
    quoted = _QUOTED.match(part)
    text = quoted[1] if quoted else part
    if holder == "launch" and _PLACEHOLDER.fullmatch(text):
        return None
    weak = _WEAK.match(text) is not None
    if not weak and (_NO_VALUE.match(text) or is_stand_in(text) or has_placeholder(text)):
        return None
    sample = _stands_in(part) or (in_address is not None and text == "pass")
    return Secret(part, name, holder, weak, sample)


def assigned_secret(text: Located) -> Secret | None:
    """The secret that a text of the form ``NAME=value`` or ``NAME: value`` holds."""
    found = _ASSIGNMENT.search(text)
    return secret(found["name"], text.part(*found.span("value")), "file") if found else None


def _stands_in(text: str) -> bool:
    """Whether a word of documentation is in the place of the secret."""
    return text.upper().endswith("EXAMPLE") or bool(_DUMMY.fullmatch(text))


def _of_password(password: Password, holder: str) -> Secret | None:
    """The secret that a password is, unless it only stands in for one."""
    value = password.value
    weak = password.known or _WEAK.match(value) is not None
    if not weak and (value.startswith("$") or is_stand_in(value) or has_placeholder(value)):
        return None
    return Secret(value, password.name, holder, weak, password.factory or _stands_in(value))


def _of_environment(runner: Runner) -> Iterator[Secret]:
    """The variables that a runner sets itself; those of environment files belong to the file."""
    files = {source for _, source in runner.environment_files}
    for chain in runner.environment.chains.values():
        for variable in chain:
            if variable.value.span.source not in files and variable.value != variable.name:
                yield from _one(secret(variable.name, variable.value, HOLDERS.get(runner.kind, "file")))


def _of_commands(runner: Runner) -> Iterator[Secret]:
    """What the command lines hold themselves; scripts are read as programs."""
    if runner.kind is RunnerKind.SCRIPT:
        return
    for line in runner.lines:
        for step in line.steps:
            if step.script is None:
                holder = _COMMANDS.get(runner.kind, "process")
                yield from _of_words(step.command.assignments, step.command.words, holder)


def _of_other_units(units: Units) -> Iterator[Secret]:
    """The variables of sockets, mounts and the like, which run commands too."""
    for unit in units.judged:
        if unit.type == "service":
            continue
        for variable in (each for chain in units.environment(unit).chains.values() for each in chain):
            if variable.origin == "Environment=":
                yield from _one(secret(variable.name, variable.value, "unit"))


def _of_words(assignments: tuple[Located, ...], words: tuple[Located, ...], holder: str) -> Iterator[Secret]:
    for word in (*assignments, *words):
        name, equals, _ = word.partition("=")
        if equals and re.fullmatch(r"[A-Za-z_]\w*", name):
            yield from _one(secret(name, word.part(len(name) + 1, len(word)), holder))
    for at, word in enumerate(words):
        option = _OPTION.fullmatch(word)
        if option and option[2] is not None:
            yield from _one(secret(option[1], word.part(option.start(2), len(word)), holder))
        elif option and at + 1 < len(words) and not words[at + 1].startswith("-"):
            yield from _one(secret(option[1], words[at + 1], holder))


def is_private(source: Source) -> bool:
    """Whether only the owner and a group may read the file, as its real permissions say."""
    return source.mode is not None and not source.mode & 0o007


def _of_images(dockerfiles: Iterable[Dockerfile]) -> Iterator[Secret]:
    """ENV and ARG stay in the layers of an image, those of the stages that are not run too."""
    from bringup_lint.parsers.dockerfile import assignments

    for file in dockerfiles:
        for instruction in file.instructions:
            if instruction.name in ("ENV", "ARG"):
                for name, value in assignments(instruction):
                    yield from _one(secret(name, value, "image"))


def _in_settings(source: Source) -> Iterator[Secret]:
    for found in _TOKEN.finditer(source.text):
        value = source.located(*found.span())
        name, equals, _ = source.line_text(value.span.line).partition("=")
        yield from _one(secret(name.strip(" \t#") if equals else "This token", value, "file"))


def _of_programs(files: Files) -> Iterator[Secret]:
    for each in assigned(files):
        found = secret(each.name, each.value, "program")
        if found is not None and not found.weak:
            yield found


def _of_written(scripts: Scripts, joined: AbstractSet[Span]) -> Iterator[Secret]:
    """What scripts write to files that are of no kind: a password alone in a file of that name, and
    ``password = ...`` lines."""
    for source, written in scripts.written("pass", "pwd", "psk", "secret", "token", "PASS"):
        if written.where.span in joined:
            continue
        text = str(written.text or "")
        if text.count("\n") <= 1 and _NAME.search(written.path):
            yield from _one(_written_secret(source, written, written.path.rpartition("/")[2], 0, len(text.rstrip())))
        for line in _SETTING.finditer(text):
            yield from _one(_written_secret(source, written, line["name"], *line.span("value")))


def _written_secret(source: Source, written: Written, name: str, start: int, end: int) -> Secret | None:
    if written.text is None or end <= start:
        return None
    place = Origin(written.where.span, written.text.pieces).span(start, end)
    value = source.located(place.start, place.end)
    return None if re.search(r"[\s{}$*]", value) else secret(name, value, "file")


def _one(found: Secret | None) -> Iterator[Secret]:
    if found is not None:
        yield found
