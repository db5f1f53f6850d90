"""The configuration: ``bringup-lint.toml``, or ``[tool.bringup-lint]`` in ``pyproject.toml``.

``OPTIONS`` is the one definition: reading, the messages about mistakes and the published JSON schema come from it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import islice

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover import disk
from bringup_lint.discover.gitignore import PatternError
from bringup_lint.discover.gitignore import pattern_of
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import read_bytes
from bringup_lint.facts.ros import distros
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.spelling import meant
from bringup_lint.toml import line_of
from bringup_lint.toml import read_toml
from bringup_lint.type_names import Any

FILE_NAME = "bringup-lint.toml"
SEVERITIES = ("info", "warning", "error")
OFF = "off"
"""In place of a severity: the rule does not run."""
ROS_DISTROS = distros.supported()
PURPOSES = ("robot", "development", "simulation", "test", "ci", "example", "archive")


OLDEST_SYSTEMD, NEWEST_SYSTEMD = 245, 257
SIZE_LIMIT = 1024 * 1024
"""Bytes of a configuration file."""
MOST = 1000
"""Entries of a list or table in a configuration that was found: each is compared with all files or rules."""
MOST_SAID = 20
"""Mistakes of a configuration that are named."""
_TABLE = regex(r"^[ \t]*\[[ \t]*tool[ \t]*(?:\]|\.[ \t]*[\"']?bringup[-_]lint)", re.M)


class ConfigError(Exception):
    """Mistakes in the configuration; its text is one clear line for each."""

    def __init__(self, text: str, config: Config | None = None):
        super().__init__(text)
        self.config = config
        """What is right in the file, where a file is wrong in part."""


class Option(NamedTuple):
    """One key of the configuration file."""

    type: str
    """``string``, ``integer``, ``strings`` (a list), ``severity``, ``ros``, or a table: ``paths``, ``purposes``,
    ``severities``, ``names`` (of lists)."""
    help: str


OPTIONS = {
    "select": Option("strings", "Rules or families to run; all when empty."),
    "ignore": Option("strings", "Rules or families to leave out."),
    "exclude": Option(
        "strings", "Files and folders to skip, as gitignore patterns relative to the configuration file."
    ),
    "min-severity": Option("severity", "The lowest severity that is shown."),
    "fail-on": Option("severity", "The lowest severity that makes the exit code 1."),
    "severity": Option(
        "severities",
        "Rules with another severity than their own: a table of rule or family to severity, or to off. A rule's own"
        " entry counts more than its family's.",
    ),
    "per-file-ignores": Option(
        "names",
        "Rules or families that are silent in some files: a table of gitignore pattern, relative to the configuration"
        " file, to a list of names.",
    ),
    "target-ros": Option("ros", "The ROS distribution that the robot runs."),
    "target-systemd": Option("integer", "The systemd version that the robot runs, 245 to 257."),
    "deploy": Option("paths", "Where files of the repository go: a table of path or folder to the path on the robot."),
    "purpose": Option(
        "purposes", "What files are for, where their paths do not say it: a table of path or folder to a purpose."
    ),
    "baseline": Option("string", "A baseline file; the findings it holds are not reported again."),
    "rules": Option("strings", "Folders of further rules; only read when the command line names this file."),
}


@dataclass(frozen=True)
class Config:
    """The settings of a run, from the file and then the command line."""

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    exclude: tuple[str, ...] = ()
    min_severity: str = "warning"
    fail_on: str = "warning"
    severity: dict[str, str] = field(default_factory=dict)
    per_file_ignores: dict[str, tuple[str, ...]] = field(default_factory=dict)
    target_ros: str | None = None
    target_systemd: int | None = None
    deploy: dict[str, str] = field(default_factory=dict)
    purpose: dict[str, str] = field(default_factory=dict)
    baseline: str | None = None
    rules: tuple[str, ...] = ()
    path: str | None = None
    """The file that was read, or None."""
    text: str = ""
    """What the file holds."""
    found: Config | None = None
    """The settings of the file alone, when it was found in the tree and not named: they are not the user's own."""

    @property
    def left_out(self) -> tuple[str, ...]:
        """The rules or families that the command line leaves out."""
        return self.ignore[len(self.found.ignore) :] if self.found else self.ignore

    def place(self, word: str) -> str:
        """Where the file says a word, for the beginning of a message; empty when it does not."""
        return f"{_place(self.path, self.text, word)}: " if self.path and word in self.text else ""

    @property
    def folder(self) -> str:
        """What relative paths in the configuration are relative to."""
        return os.path.dirname(self.path) if self.path else os.getcwd()

    def beside(self, path: str) -> str:
        """What a relative path in the configuration leads to."""
        return disk.tidied(os.path.join(self.folder, path))


def find(start: str) -> str | None:
    """The nearest configuration at or above ``start``; the search ends at the top of a repository."""
    for folder in (start, *disk.above(start)):
        own = os.path.join(folder, FILE_NAME)
        if disk.lexists(own):
            return own
        pyproject = os.path.join(folder, "pyproject.toml")
        if disk.lexists(pyproject) and _TABLE.search(_text_of(pyproject, named=False)):
            return pyproject
        if disk.lexists(os.path.join(folder, ".git")):
            return None
    return None


def read(path: str, *, named: bool = True) -> Config:
    """Read a configuration file. Raises ConfigError with the file's name in the text.

    One that the user did not name was found in the tree and is not trusted: it is no link out of the tree, and names
    nothing outside.
    """
    text = _text_of(path, named)
    try:
        data = read_toml(text)
    except (ValueError, RecursionError) as error:
        why = "nested too deep" if isinstance(error, RecursionError) else error
        line = line_of(error, text)
        raise ConfigError(f"{path}{f':{line}' if line else ''}: {why}") from error
    values: dict[str, Any] = {}
    wrong: list[tuple[str, str]] = []
    for key, value in _table(path, text, data).items():
        try:
            values[key.replace("-", "_")] = _setting(key, value, named)
        except ValueError as error:
            wrong.append((key, str(error)))
    config = Config(**values, path=path, text=text)
    wrong += islice(_without_effect(config, named), MOST_SAID + 1)
    if wrong:
        lines = [f"{_place(path, text, word)}: {why}" for word, why in wrong[:MOST_SAID]]
        raise ConfigError("\n".join([*lines, *[f"{path}: and more"][: len(wrong) - len(lines)]]), config)
    return config


def _setting(key: str, value: object, named: bool) -> object:
    """The value of a key. Raises ValueError."""
    if key not in OPTIONS:
        raise ValueError(f"unknown key '{key}'{_did_you_mean(key)}")
    try:
        checked = _checked(OPTIONS[key].type, value)
    except ValueError as error:
        raise ValueError(f"{key} {error}") from error
    if not named and _size(checked) > MOST:
        raise ValueError(f"{key} has more than {MOST} entries; name the file: --config")
    return checked


def _text_of(path: str, named: bool) -> str:
    """The text of a configuration file. Raises ConfigError."""
    if not named and not _is_inside(path, os.path.dirname(path)):
        raise ConfigError(f"{path}: a symbolic link leads out of the tree; --isolated reads no configuration")
    try:
        data, _ = read_bytes(path, SIZE_LIMIT, follow=True)
        return data.decode("utf-8")
    except Unreadable as error:
        raise ConfigError(f"{path}: {error}") from error
    except UnicodeDecodeError as error:
        raise ConfigError(f"{path}: not UTF-8: byte 0x{data[error.start]:02x}") from error


def _is_inside(path: str, folder: str) -> bool:
    """Whether a path leads to a place in the repository around a folder, or else in the folder."""
    tops = (each for each in (folder, *disk.above(folder)) if disk.lexists(os.path.join(each, ".git")))
    top = disk.realpath(next(tops, folder))
    try:
        real = disk.realpath(path)
    except ValueError:
        return False
    return real == top or real.startswith(top.rstrip("/") + "/")


def _size(value: object) -> int:
    """How many entries a list or table has, with those of the lists in it."""
    if isinstance(value, dict):
        return sum(max(_size(each), 1) for each in value.values())
    return len(value) if isinstance(value, tuple) else 0


def _table(path: str, text: str, data: dict[str, Any]) -> dict[str, Any]:
    """The settings: all of the file's own, or the table of ``pyproject.toml``. Raises ConfigError."""
    if os.path.basename(path) != "pyproject.toml":
        if "tool" in data:
            raise ConfigError(f"{_place(path, text, 'tool')}: write the keys themselves, without [tool.bringup-lint]")
        return data
    tools = data.get("tool", {})
    if not isinstance(tools, dict):
        return {}
    if "bringup_lint" in tools:
        place = _place(path, text, "bringup_lint")
        raise ConfigError(f"{place}: [tool.bringup_lint] has no effect; did you mean [tool.bringup-lint]?")
    table = tools.get("bringup-lint", {})
    if not isinstance(table, dict):
        raise ConfigError(f"{_place(path, text, 'bringup-lint')}: [tool.bringup-lint] must be a table")
    return table


def _without_effect(config: Config, named: bool) -> Iterator[tuple[str, str]]:
    """Words of the configuration that would change nothing, or lead out of the tree, and why."""
    version = config.target_systemd
    if version is not None and not OLDEST_SYSTEMD <= version <= NEWEST_SYSTEMD:
        yield str(version), f"target-systemd must be {OLDEST_SYSTEMD} to {NEWEST_SYSTEMD}, not {version}"
    for key, table in (("deploy", config.deploy), ("purpose", config.purpose)):
        for path in table:
            if "\0" in path or not disk.lexists(config.beside(path)):
                yield path, f"{key}: there is no '{path}' beside the configuration"
    for pattern in config.exclude:
        try:
            pattern_of(pattern)
        except PatternError as error:
            yield pattern, f"exclude: {error}"
    if config.baseline and not named and not _is_inside(config.beside(config.baseline), config.folder):
        yield config.baseline, f"baseline: '{config.baseline}' lies outside of the tree; name it with --baseline"


def _place(path: str, text: str, word: str) -> str:
    """The file, and the line that says a word: as a key, else anywhere."""
    lines = text.splitlines()
    key = re.compile(rf"""\s*\[?\s*["']?{re.escape(word)}["']?\s*[=\]]""")
    for says in (key.match, lambda line: word in line):
        for number, line in enumerate(lines, 1):
            if says(line):
                return f"{path}:{number}"
    return path


_CHOICES = {
    "severity": SEVERITIES,
    "severity or off": (*SEVERITIES, OFF),
    "ros": ROS_DISTROS,
    "purpose": PURPOSES,
}


def _did_you_mean(key: str) -> str:
    near = meant(key.replace("_", "-"), OPTIONS)
    return f"; did you mean '{near}'?" if near else f"; known keys: {', '.join(OPTIONS)}"


def _checked(kind: str, value: Any) -> Any:
    if kind == "strings":
        if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
            raise ValueError("must be a list of strings")
        return tuple(value)
    if kind == "names":
        if not isinstance(value, dict):
            raise ValueError("must be a table of lists of strings")
        return _each("strings", value)
    if kind in ("paths", "severities", "purposes"):
        if not isinstance(value, dict) or not all(isinstance(item, str) for item in value.values()):
            raise ValueError("must be a table of strings")
        if kind == "severities":
            value = _each("severity or off", value)
        if kind == "purposes":
            value = _each("purpose", value)
        return value
    if kind == "integer":
        if not isinstance(value, int) or isinstance(value, bool):
            raise ValueError("must be a whole number")
        return value
    if not isinstance(value, str):
        raise ValueError("must be a string")
    choices = _CHOICES.get(kind)
    if choices and value not in choices:
        raise ValueError(f"must be one of {', '.join(choices)}, not '{value}'")
    return value


def _each(kind: str, table: dict[str, Any]) -> dict[str, Any]:
    """The table with its values checked. Raises ValueError that names each mistake once."""
    found: dict[str, Any] = {}
    wrong: dict[str, None] = {}
    for key, value in table.items():
        try:
            found[key] = _checked(kind, value)
        except ValueError as error:
            wrong[str(error)] = None
    if wrong:
        raise ValueError("; ".join(islice(wrong, MOST_SAID)))
    return found


def schema() -> dict[str, Any]:
    """The JSON schema (draft 2020-12) of the configuration file."""
    from dataclasses import fields

    string = {"type": "string"}
    severity = {"enum": list(SEVERITIES)}
    types: dict[str, dict[str, Any]] = {
        "string": string,
        "integer": {"type": "integer", "minimum": OLDEST_SYSTEMD, "maximum": NEWEST_SYSTEMD},
        "strings": {"type": "array", "items": string, "uniqueItems": True},
        "severity": severity,
        "severities": {"type": "object", "additionalProperties": {"enum": [*SEVERITIES, OFF]}},
        "names": {"type": "object", "additionalProperties": {"type": "array", "items": string}},
        "ros": {"enum": list(ROS_DISTROS)},
        "paths": {"type": "object", "additionalProperties": string},
        "purposes": {"type": "object", "additionalProperties": {"enum": list(PURPOSES)}},
    }
    defaults = {item.name.replace("_", "-"): item.default for item in fields(Config()) if isinstance(item.default, str)}
    properties = {}
    for key, option in OPTIONS.items():
        properties[key] = {"description": option.help, **types[option.type]}
        if key in defaults:
            properties[key]["default"] = defaults[key]
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "bringup-lint configuration",
        "type": "object",
        "additionalProperties": False,
        "properties": properties,
    }
