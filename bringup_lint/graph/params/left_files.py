"""Parameter files that the tree has and that nothing of it loads."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.memo import kept
from bringup_lint.graph.params.naming import BUILD
from bringup_lint.graph.purpose import Purpose
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.source import Source

_MOST = 200_000
"""Characters of a page that are looked at."""
_PUT_TOGETHER = regex(
    r"(?:\$\w{1,40}|%(?:\(\w{1,40}\))?[sd]|(?<![\w./-]))(?P<end>[\w.-]{0,80}\.ya?ml)\b", hints=".yaml .yml"
)
"""A name of a parameter file that does not follow a slash, and so may be the end of one: ``robot + "_config.yaml"``,
``f"{robot}.yaml"``, ``"%s.yaml"``."""
_LISTS = regex(r"\b(?:listdir|scandir|iterdir|r?glob|walk)\(", hints="listdir scandir iterdir glob walk")
"""What takes all files of a folder."""
_IMPORTED = regex(r"(?m)^[ \t]*(?:from|import)[ \t]+(\w+)")


def is_left(params: Params, file: ParameterFile) -> bool:
    """Whether the tree starts nodes, nothing of it names a file, and nothing that may know its package puts the name
    together or takes what is in a folder."""
    return not params.is_used(file) and not _may_be_composed(params, file) and is_unnamed(params, file)


def _may_be_composed(params: Params, file: ParameterFile) -> bool:
    owner, name = params.launch().workspace.owner(file.source), file.source.basename
    ends = _askers(params)
    askers = (each for at in range(1, len(name)) for each in ends.get(name[at:], ()))
    return any(
        owner is None or asker is None or asker is owner or owner.name in source.text
        for source, asker in askers
        if source is not file.source
    )


@kept
def _askers(params: Params) -> dict[str, list[tuple[Source, Package | None]]]:
    """End of names that a text puts together -> the sources that do, with their packages."""
    found: dict[str, list[tuple[Source, Package | None]]] = {}
    owner = params.launch().workspace.owner
    for source in params.files.sources:
        ends = frozenset(_ends(source)) if source.kind not in BUILD else frozenset()
        if ends and params.files.purpose(source) is not Purpose.CI:
            for end in ends:
                found.setdefault(end, []).append((source, owner(source)))
    return found


def _ends(source: Source) -> Iterator[str]:
    """With what the names of parameter files may end that a text puts together; the ends of all of them where it takes
    what is in a folder."""
    if source.kind == "launch-python" and _LISTS.search(source.uncommented):
        yield from (".yaml", ".yml")
    yield from (match["end"] for match in _PUT_TOGETHER.finditer(source.uncommented))


def is_unnamed(params: Params, file: ParameterFile) -> bool:
    """Whether the tree starts nodes, and nothing that may open a file names it."""
    if params.loads(file) or not params.files.of_kind(*LAUNCH):
        return False
    name, workspace = file.source.basename, params.launch().workspace
    owner = workspace.owner(file.source)
    sources = (each for each in params.files.sources if each is not file.source and each.kind not in BUILD)
    named = [each for each in sources if name in each.text and _opens(each, name)]
    if owner is not None:
        named = [each for each in named if owner.name in each.text or workspace.owner(each) is owner]
    return all(_hands_to_helper(params, each) for each in named) and not _is_in_guide(params, name)


def _opens(source: Source, name: str) -> bool:
    """Whether a source that holds the name of a file may open it: code has it as a text, not in what it says."""
    if source.kind not in ("python-node", "cpp-node"):
        return True
    return re.search(rf"{re.escape(name)}[\"'](?!\w)", source.uncommented) is not None


def _is_in_guide(params: Params, name: str) -> bool:
    """Whether a page of the tree has people give a file to a node: ros2 launch takes no such option."""
    tree = params.files.tree
    told = regex(rf"(?m)^(?![^\n]*\bros2 launch\b)[^\n]*--params-file[ \t=]+[^\s`\"']*{re.escape(name)}\b")
    return any(told.search(tree.head(path, _MOST)) for path in tree.paths if path.endswith(".md"))


def _hands_to_helper(params: Params, source: Source) -> bool:
    """Whether a launch file works with code of a package of the tree, which may read a file and write another."""
    packages = params.launch().workspace.packages
    return source.kind == "launch-python" and any(each in packages for each in _IMPORTED.findall(source.text))
