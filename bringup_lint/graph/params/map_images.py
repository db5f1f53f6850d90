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
    from bringup_lint.graph.files import Files

_IMAGE = regex(r"^image:[ \t]+['\"]?([^\s'\"#]+)['\"]?[ \t]*(?:#[^\n]*)?\r?$", re.M)
_IS_MAP = regex(r"^(?:resolution|occupied_thresh):", re.M)
_PLAIN = regex(r"(?:/home/[\w.-]+/)?[^/~$]")
_ENDINGS = (".pgm", ".png", ".bmp")
_HEAD = 2_000
"""Characters that a map is described in."""


class LostImage(NamedTuple):
    image: Located
    beside: str
    """The image in the same folder that no map names, or that the map means."""
    is_of_home: bool = False
    """The map names the image by its path in the home folder of somebody."""


def lost_images(files: Files) -> Iterator[LostImage]:
    """The maps whose image does not exist, where their folder has one that no map names."""
    tree = files.tree
    for path in tree.paths:
        if not _may_be_map(path) or not _IS_MAP.search(tree.head(path, _HEAD)):
            continue
        source = tree.at(path)
        image = _image(source) if source is not None else None
        if source is None or image is None:
            continue
        if image.startswith("/home/"):
            if _is_there(tree, path, os.path.basename(image)) and not _is_home_of_robot(files, image, source):
                yield LostImage(image, os.path.basename(image), is_of_home=True)
            continue
        if _is_there(tree, path, str(image)):
            continue
        spare = _spare(tree, path)
        if spare is not None:
            yield LostImage(image, spare)


def _may_be_map(path: str) -> bool:
    """Whether a file is called as maps are, or lies in a folder of them."""
    return path.endswith((".yaml", ".yml")) and any("map" in part.lower() for part in path.split("/")[-2:])


def _image(source: Source) -> Located | None:
    match = _IMAGE.search(source.text)
    is_plain = match is not None and match[1].endswith(_ENDINGS) and _PLAIN.match(match[1])
    return Located(match[1], source.span(*match.span(1))) if match is not None and is_plain else None


def _is_there(tree: Tree, path: str, image: str) -> bool:
    there = os.path.normpath(os.path.join(os.path.dirname(path), image))
    return tree.exists(there) or tree.is_ignored(there)


def _is_home_of_robot(files: Files, image: str, source: Source) -> bool:
    """Whether anything else of the tree speaks of the same home folder."""
    home = "/".join(image.split("/")[:3]) + "/"
    return any(home in each.text for each in files.sources if each is not source)


def _spare(tree: Tree, map_path: str) -> str | None:
    """The one image beside a map that no map of the folder names; of several the one that is called like the map."""
    folder, name = os.path.split(map_path)
    inside = [path for path in tree.paths if os.path.dirname(path) == folder]
    named = " ".join(tree.head(path, _HEAD) for path in inside if path.endswith((".yaml", ".yml")))
    images = (os.path.basename(path) for path in tree.names_below(folder, 1) if path.endswith(_ENDINGS))
    spare = sorted({image for image in images if image not in named})
    same = [image for image in spare if os.path.splitext(image)[0] == os.path.splitext(name)[0]]
    return (same or spare)[0] if len(spare) == 1 or len(same) == 1 else None
