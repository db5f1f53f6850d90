"""The settings of a run, from the configuration and the command line."""

from __future__ import annotations

import os
from collections.abc import Iterable

from bringup_lint.cli.run_options import RunOptions
from bringup_lint.cli.streams import complain
from bringup_lint.config import Config
from bringup_lint.config import ConfigError
from bringup_lint.config import find
from bringup_lint.config import read
from bringup_lint.dataclass import replace
from bringup_lint.discover import disk
from bringup_lint.type_names import Any


def configuration(paths: tuple[str, ...], options: RunOptions) -> tuple[Config, list[str]]:
    """The settings from file and command line, and the folders of further rules. Raises ConfigError."""
    named = str(options.config_path or "")
    path = named or (None if options.isolated else find(_start(paths, options.root)))
    try:
        config = read(path, named=bool(named)) if path else Config()
    except ConfigError as error:
        raise _with_unknown_names(error, map(str, options.rule_folders)) from error
    found = config if path and not named else None
    rule_folders = [str(folder) for folder in options.rule_folders]
    if config.rules and named:
        rule_folders += map(config.beside, config.rules)
    elif config.rules:
        complain(f"{path}: 'rules' is only read from a file named by --config")
    given: dict[str, Any] = {
        "select": options.select,
        "ignore": (*config.ignore, *options.ignore),
        "exclude": (*config.exclude, *options.exclude),
        "min_severity": options.min_severity,
        "fail_on": options.fail_on,
        "target_ros": options.target_ros,
        "target_systemd": options.target_systemd,
        "baseline": options.baseline and str(options.baseline.absolute()),
        "found": found,
    }
    return replace(config, **{key: value for key, value in given.items() if value}), rule_folders


def _with_unknown_names(error: ConfigError, rule_folders: Iterable[str]) -> ConfigError:
    """The mistakes of a configuration, and the names in it that mean no rule."""
    from bringup_lint.registry import Registry
    from bringup_lint.selection import Selection

    if error.config is None or error.config.rules:
        return error
    try:
        Selection(Registry.of(rule_folders), error.config)
    except ConfigError as unknown:
        return ConfigError(f"{error}\n{unknown}")
    return error


def _start(paths: tuple[str, ...], root: str | None) -> str:
    """Where the search for a configuration begins: at the first path, which lies in the root when there is one."""
    first = disk.absolute(os.path.join(root, paths[0].lstrip("/")) if root else paths[0])
    return first if disk.isdir(first) else os.path.dirname(first)
