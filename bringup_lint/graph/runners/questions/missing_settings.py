"""Files that a variable of a container names, such as a profile of DDS, and that nothing brings into it."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.source import Located


class MissingSettings(NamedTuple):
    value: Located
    """Of the variable."""
    path: str
    runner: Runner


def missing_settings(
    files: Files, containers: Iterable[Runner], name: str, paths_of: Callable[[str | None], list[str]]
) -> Iterator[MissingSettings]:
    """What is missing in the containers that run ROS, for each value of the variable that names it."""
    for runner in containers:
        found = runner.environment.get(name) if runner.runs_ros else None
        path = None if found is None else _missing(files, runner, paths_of(found.text))
        if found is not None and path is not None and not _is_written(runner, path):
            yield MissingSettings(found.value, path, runner)


def _missing(files: Files, runner: Runner, paths: list[str]) -> str | None:
    from bringup_lint.graph.runners.questions.missing_programs import lacks

    return next((each for each in paths if lacks(files, runner, each)), None)


def _is_written(runner: Runner, path: str) -> bool:
    """Whether the container may make the file itself when it starts."""
    words = (word for each in runner.commands if each.name not in ("export", "test", "[", "[[") for word in each.words)
    targets = (str(redirect.target) for each in runner.commands for redirect in each.redirects)
    return path.startswith(("/tmp/", "/run/")) or any(path in word for word in (*words, *targets))
