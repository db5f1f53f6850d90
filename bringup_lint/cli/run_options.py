"""What the command line says of a run."""

from __future__ import annotations

from collections.abc import Mapping

from bringup_lint.dataclass import dataclass
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any

if TYPE_CHECKING:
    from datetime import datetime
    from pathlib import Path


@dataclass
class RunOptions:
    """The options of ``bringup-lint check``, of which other commands offer some, with their values where they are not
    given."""

    output_format: tuple[str, ...] = ()
    output_file: tuple[Path, ...] = ()
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    rule_folders: tuple[Path, ...] = ()
    exclude: tuple[str, ...] = ()
    root: str | None = None
    min_severity: str | None = None
    fail_on: str | None = None
    target_ros: str | None = None
    target_systemd: int | None = None
    now: datetime | None = None
    config_path: Path | None = None
    stdin_filename: str | None = None
    since: str | None = None
    baseline: Path | None = None
    write_baseline: Path | None = None
    add_ignores: str | None = None
    colour: bool | None = None
    exit_zero: bool = False
    no_ignores: bool = False
    isolated: bool = False
    tracked: bool = False
    changed: bool = False
    prune_baseline: bool = False
    quiet: bool = False
    statistics: bool = False
    show_files: bool = False
    show_settings: bool = False
    fix: bool = False
    unsafe_fixes: bool = False
    diff: bool = False
    no_cache: bool = False
    cache_by: str = "times"
    stdin_data: bytes = b""
    """What standard input holds, or what fixes made of it; read where ``stdin_filename`` names it."""

    @staticmethod
    def of(given: Mapping[str, Any]) -> RunOptions:
        """Those among the options of a command."""
        return RunOptions(**{name: value for name, value in given.items() if name in RunOptions.__annotations__})
