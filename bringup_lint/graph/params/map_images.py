"""Maps of map_server whose image is not where the file says."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree

_IMAGE = regex(r"^image:[ \t]+['\"]?([^\s'\"#]+)['\"]?[ \t]*(?:#[^\n]*)?\r?$", re.M)
_IS_MAP = regex(r"^(?:resolution|occupied_thresh):", re.M)
_ENDINGS = (".pgm", ".png", ".bmp")
_HEAD = 2_000
"""Characters that a map is described in."""


class LostImage(NamedTuple):
    image: Located
    beside: str
    """The image in the same folder that no map names."""


def lost_images(tree: Tree) -> Iterator[LostImage]:
    """The maps whose image does not exist, where their folder has one that no map names."""
    for path in tree.paths:
        if not _may_be_map(path) or not _IS_MAP.search(tree.head(path, _HEAD)):
            continue
        source = tree.read(path)
        image = _image(source) if source is not None else None
        if image is None or _is_there(tree, path, str(image)):
            continue
        spare = _spare(tree, os.path.dirname(path))
        if spare is not None:
            yield LostImage(image, spare)


def _may_be_map(path: str) -> bool:
    """Whether a file is called as maps are, or lies in a folder of them."""
    return path.endswith((".yaml", ".yml")) and any("map" in part.lower() for part in path.split("/")[-2:])


def _image(source: Source) -> Located | None:
    match = _IMAGE.search(source.text)
    is_plain = match is not None and match[1].endswith(_ENDINGS) and match[1][0] not in "/~$"
    return Located(match[1], source.span(*match.span(1))) if match is not None and is_plain else None


def _is_there(tree: Tree, path: str, image: str) -> bool:
    there = os.path.normpath(os.path.join(os.path.dirname(path), image))
    return tree.exists(there) or tree.is_ignored(there)


def _spare(tree: Tree, folder: str) -> str | None:
    """The one image of a folder that no map of the folder names."""
    inside = [path for path in tree.paths if os.path.dirname(path) == folder]
    named = " ".join(tree.head(path, _HEAD) for path in inside if path.endswith((".yaml", ".yml")))
    images = (os.path.basename(path) for path in tree.names_below(folder, 1) if path.endswith(_ENDINGS))
    spare = sorted({image for image in images if image not in named})
    return spare[0] if len(spare) == 1 else None
