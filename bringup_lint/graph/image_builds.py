"""Parts of trees that a build system joins with others to the image of a robot: layers of Yocto, trees of Buildroot and
modules of CustomPiOS. What such a part lacks, another one may bring."""

from __future__ import annotations

import posixpath
import re

from bringup_lint.discover.tree import is_below
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.source import Source

_OF_BUILDROOT = ("Config.in", "external.mk", "external.desc")
_OF_CUSTOMPIOS = regex(
    r"^[ \t]*(?:source|\.)[ \t]+/common\.sh\b|\binstall_cleanup_trap\b|^[ \t]*unpack[ \t]+/filesystem", re.M
)
"""Functions that only the scripts of CustomPiOS have, which run in the file system of the image."""


def layers(tree: Tree) -> list[str]:
    """The folders of the layers of Yocto: each has a conf/layer.conf."""
    found = (posixpath.dirname(path) for path in tree.named("layer.conf"))
    return [posixpath.dirname(folder) for folder in found if posixpath.basename(folder) == "conf"]


def is_in_layer(tree: Tree, source: Source) -> bool:
    return is_below(source.absolute, layers(tree))


def has_busybox(tree: Tree, source: Source) -> bool:
    """Whether a script is for an image whose ``/bin/sh`` is that of BusyBox."""
    of_buildroot = (posixpath.dirname(path) for name in _OF_BUILDROOT for path in tree.named(name))
    return is_in_layer(tree, source) or is_below(source.absolute, of_buildroot)


def runs_in_image(source: Source) -> bool:
    """Whether a script runs while an image is built, on which nothing has started yet."""
    return source.matches(_OF_CUSTOMPIOS)
