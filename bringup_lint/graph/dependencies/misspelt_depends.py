"""Dependencies in package.xml that nobody has, and that are a letter away from one that somebody has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.needed import base
from bringup_lint.facts.ros.released import near_current
from bringup_lint.facts.ros.released import released
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import Neighbours
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.model.package import Manifest
    from bringup_lint.source import Located

_SHORTEST = 6


class MisspeltDependency(NamedTuple):
    name: Located
    meant: str
    place: Located | None
    """Where the tree names what is meant."""


def misspelt_dependencies(
    workspace: Workspace, manifests: list[Manifest], is_fetched: Callable[[str], bool]
) -> Iterator[MisspeltDependency]:
    """Those that one package.xml alone names, under no condition."""
    declared = Counter(str(name) for each in manifests for name in {str(name) for _, name in each.depends})
    places = {str(name): name for each in manifests for _, name in each.depends}
    places |= {str(each.name): each.name for each in manifests if each.name}
    own = {*workspace.packages, *workspace.ambiguous, *(str(each.name) for each in manifests)}
    known = Neighbours((*own, *(name for name, count in declared.items() if count > 1)))
    for manifest in manifests:
        for tag, name in manifest.depends:
            text = str(name)
            if text in own or text in released() or declared[text] > 1 or tag == "group_depend" or is_fetched(text):
                continue
            meant = _near(text, known)
            if meant is not None and "condition=" not in name.span.source.line_text(name.span.line):
                yield MisspeltDependency(name, meant, places.get(meant))


def _near(word: str, known: Neighbours) -> str | None:
    if len(word) < _SHORTEST or word in known.known or word in near_current().known:
        return None
    found = dict.fromkeys((*known.meant(word), *near_current().meant(word)))
    near = [each for each in found if not numbered(each, word) and each[0] == word[0]]
    return near[0] if len(near) == 1 and _is_meant(word, near[0]) else None


def _is_meant(word: str, meant: str) -> bool:
    """Whether a name of one word, which may be that of a system package, is one of every robot, and no other spelling
    or number of the same is meant."""
    is_plain = "_" not in meant and "-" not in meant and meant not in base()
    is_same = word.replace("-", "_") == meant.replace("-", "_") or word in (f"{meant}s", meant.removesuffix("s"))
    return not is_plain and not is_same
