"""From the paths of the command line, or standard input, to a robot."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from collections.abc import Iterable

from bringup_lint.cli.run_options import RunOptions
from bringup_lint.config import Config
from bringup_lint.config import ConfigError
from bringup_lint.discover import disk
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.discover.held import Held
    from bringup_lint.robot import Robot


def read_robot(paths: tuple[str, ...], config: Config, options: RunOptions, held: Held | None = None) -> Robot:
    """Read the paths, or standard input, into a robot."""
    from bringup_lint.discover.exclude import exclusion
    from bringup_lint.discover.exclude import noting
    from bringup_lint.discover.tree import display_name
    from bringup_lint.discover.walk import discover
    from bringup_lint.discover.walk import discover_text
    from bringup_lint.discover.walk import missing
    from bringup_lint.robot import Robot

    if options.stdin_filename:
        tree = discover_text(options.stdin_filename, options.stdin_data)
    else:
        if why := missing(paths, options.root):
            raise ConfigError(why)
        deploy = {config.beside(path): place for path, place in config.deploy.items()}
        excluded = exclusion(config.folder, config.exclude, _folders(paths, options.root))
        met: set[str] = set()
        if config.found and config.found.exclude:
            excluded = noting(excluded, met)
        if options.tracked:
            excluded = _untracked_too(excluded)
        tree = discover(paths, root=options.root, deploy=deploy, excluded=excluded, held=held)
        tree.excluded = met
    now = options.now
    purposes = {display_name(config.beside(path)): name for path, name in config.purpose.items()}
    return Robot(tree, config.target_ros, config.target_systemd, now.date() if now else None, purposes)


def standard_input() -> bytes:
    """Raises ConfigError when it is closed, or holds more than is read of any file."""
    from bringup_lint.discover.reading import SIZE_LIMIT

    disk.depends_on_more()
    try:
        data = sys.stdin.buffer.read(SIZE_LIMIT + 1)
    except (AttributeError, OSError, ValueError) as error:
        raise ConfigError("--stdin-filename: standard input is closed") from error
    if len(data) > SIZE_LIMIT:
        raise ConfigError(f"--stdin-filename: standard input is longer than {SIZE_LIMIT // 1024 // 1024} MiB")
    return data


def _untracked_too(excluded: Callable[[str], bool]) -> Callable[[str], bool]:
    """What is left out, and the files that git does not track. Raises ConfigError outside of a repository."""
    from bringup_lint.discover.git_index import UnknownFormat
    from bringup_lint.discover.git_index import tracked_only

    try:
        untracked = tracked_only(os.getcwd())
    except UnknownFormat as error:
        raise ConfigError(f"--tracked: {error}") from error
    return lambda path: excluded(path) or untracked(path)


def _folders(paths: Iterable[str], root: str | None) -> list[str]:
    """The absolute folders among the paths of the command line, with a slash at the end."""
    from bringup_lint.discover.walk import inside

    places = [os.path.abspath(path) if root is None else inside(disk.absolute(root), path) for path in paths]
    return [f"{place.rstrip('/')}/" for place in places if disk.isdir(place)]
