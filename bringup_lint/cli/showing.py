"""``--show-files`` and ``--show-settings``: what a run would look at, and with which settings."""

from __future__ import annotations

import json
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.config import OPTIONS
from bringup_lint.config import Config
from bringup_lint.report.columns import plain_start
from bringup_lint.report.columns import printable

if TYPE_CHECKING:
    from bringup_lint.cli.run_options import RunOptions
    from bringup_lint.robot import Robot
    from bringup_lint.source import Source

DEFAULT, COMMAND_LINE = "default", "command line"
_GIVEN = {"rules": "rule_folders"}
"""The name of a setting among the options, where it is another."""


def files(robot: Robot) -> str:
    """The files that are judged, a line each: path, kind, and the purpose where it is not the robot."""
    judged = [source for source in robot.sources if source.judged and source.origin is None]
    width = max((len(_shown(source)) for source in judged), default=0)
    rows = ((_shown(source), source.kind, str(robot.purpose(source).value)) for source in judged)
    return "".join(
        f"{name:<{width}}  {kind}{'' if purpose == 'robot' else f', {purpose}'}\n" for name, kind, purpose in rows
    )


def _shown(source: Source) -> str:
    return printable(plain_start(source.name))


def settings(config: Config, options: RunOptions, robot: Robot) -> str:
    """Every setting as the configuration writes it, with what says so."""
    lines = [line for key in OPTIONS for line in _lines(key, config, options, robot)]
    width = min(max(len(line) for line, _ in lines), 60)
    return "".join(f"{line:<{width}}  # {printable(origin)}\n" for line, origin in lines)


def _lines(key: str, config: Config, options: RunOptions, robot: Robot) -> Iterator[tuple[str, str]]:
    value = getattr(config, key.replace("-", "_"))
    given = getattr(options, _GIVEN.get(key, key.replace("-", "_")), None)
    if key == "rules":
        value = (*map(str, given or ()), *value)
    if key.startswith("target-") and not value:
        yield _target(key, robot)
    elif isinstance(value, dict):
        yield from ((f"{key}.{_quoted(name)} = {_value(item)}", _place(config, name)) for name, item in value.items())
        if not value:
            yield f"{key} = {{}}", DEFAULT
    else:
        yield f"{key} = {_value(value)}", _origin(key, value, given, config)


def _target(key: str, robot: Robot) -> tuple[str, str]:
    """What is taken where nobody says it."""
    target = robot.target
    if key == "target-ros":
        return f"{key} = {_value(target.ros)}", target.ros_why
    return f"{key} = {target.systemd}", target.systemd_why


def _origin(key: str, value: object, given: object, config: Config) -> str:
    """What says so: the command line, the file, or both of a list."""
    if key in ("ignore", "exclude") and given and value != given:
        return f"{_place(config, key)}, {COMMAND_LINE}"
    if given:
        return COMMAND_LINE
    return DEFAULT if value == getattr(Config(), key.replace("-", "_")) else _place(config, key)


def _place(config: Config, word: str) -> str:
    return config.place(word).removesuffix(": ") or str(config.path)


def _value(value: object) -> str:
    if isinstance(value, tuple):
        return f"[{', '.join(map(_quoted, value))}]"
    return '""' if value is None else _quoted(value)


def _quoted(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


def show(asked: Iterable[str], robot: Robot, config: Config, options: RunOptions) -> str:
    """The text for the options that ask for one of these."""
    texts = {"show_settings": lambda: settings(config, options, robot), "show_files": lambda: files(robot)}
    return "\n".join(texts[name]() for name in asked)
