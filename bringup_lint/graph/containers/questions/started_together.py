"""Whether one ``docker compose up`` starts two services."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.memo import kept
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import Service
    from bringup_lint.source import Source

_COMMAND = regex(r"compose\b[^\n]{0,200}?[ \"'](?:up|run|start|create)\b([^\n]{0,200})")
_WORD = regex(r"[ \"'](\$|[\w-]+)")
_VARIABLE = "$"


def start_together(files: Files, one: Service, other: Service) -> bool:
    """Whether some choice of profiles surely starts both, and nobody starts one of them alone by its name."""
    if one is other:
        return True
    if one.profiles and other.profiles and not one.profiles & other.profiles:
        return False
    alone = _started_by_name(files)
    names = {str(each.name).partition(".")[0] for each in (one, other)} | {_VARIABLE}
    return not any(files.same_robot(each, one.source) for name in names for each in alone.get(name, ()))


@kept
def _started_by_name(files: Files) -> dict[str, list[Source]]:
    """Word -> the files in which a command of docker compose may start the service of that name alone."""
    found: dict[str, list[Source]] = {}
    for source in files.sources:
        words = {word for rest in _COMMAND.findall(source.text) for word in _WORD.findall(rest)}
        for word in words:
            found.setdefault(word, []).append(source)
    return found
