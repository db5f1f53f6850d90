"""Classes of C++ that nothing of a tree but its tests makes, derives from or registers. What is found in them is
information."""

from __future__ import annotations

import os
import re
from bisect import bisect_left
from bisect import bisect_right
from functools import cached_property

from bringup_lint.endings import CPP
from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.source import Span

_METHOD = regex(
    r"(?m)^[A-Za-z_~][^\n;{}()=]{0,300}?(?<![\w:])(?:\w{1,80}::){0,8}(?P<name>\w{1,80})::~?\w{1,80}[ \t]*\("
)
"""The head of a function that is defined outside of its class, at the start of a line."""
_CLASS = regex(r"(?m)^(?:class|struct)[ \t]+(?:[A-Z_]{3,40}[ \t]+)?(?P<name>\w+)[^;{}()]{0,400}\{")
_DEFINED = r"[ \t]*\(|::~?\w+[ \t]*\(|[ \t]*(?:final[ \t]*)?[:{][^:]"
"""What follows the name of a class where it is defined, and its methods are."""
_MADE = r"(?:\b(?:new|return|throw)[ \t(]|[=(?][ \t]*|<<[ \t]*)(?:\w+::){0,8}"
"""What is before the name of a class where an object is made without a name."""
_BASE = r"\b(?:public|protected|private|virtual)[ \t]+(?:\w+::){0,8}"
"""What is before the name of a class where another builds on it."""
_CALLED = r"(?:\b(?:return|throw)[ \t]|[=(,!&|?][ \t]*|^[ \t]+)(?:\w+::){0,8}"
"""What is before the name of a class where a function of the class is called, without an object of it."""
_END = regex(r"(?m)^\}")
_REMARK = regex(r"//[^\n]*|/\*[\s\S]*?(?:\*/|\Z)|^[ \t]*#[ \t]*(?:include|ifndef|define|endif)[^\n]*", re.M)
_STARTS = regex(r"\bmain\s{0,4}\(|\b(?:RCLCPP_COMPONENTS_REGISTER_NODE|PLUGINLIB_EXPORT_CLASS)\b")
_NAMING = ("cmake", "launch-python", "launch-xml", "launch-yaml", "params", "python-node", "urdf")
_PLUGINS = regex(r"\.xml$")
_TESTS = regex(r"/tests?/")
_SIZE = 500_000
"""How much is read of a file."""
_MOST = 5_000
"""C++ files of a tree that is looked through."""


class Unmade:
    """Asked for a place: whether it is in a class that nothing makes."""

    def __init__(self, files: Files) -> None:
        self._files = files

    def has(self, place: Span) -> bool:
        if not place.source.name.endswith(CPP) or self._files.is_configured(place.source):
            return False
        name = _around(place)
        if name is None or not self._has_programs(self._package(place.source.absolute)):
            return False
        return not self._is_used((name, _stem(place.source.absolute)))

    @memo
    def _has_programs(self, package: str) -> bool:
        """Whether the C++ files of a package start or register something: what is made may be looked for there."""
        return any(path.startswith(package) and _STARTS.search(text) for path, text in self._texts.items())

    @memo
    def _package(self, path: str) -> str:
        """The folder of the package that a file is of; that of the file where it is of none."""
        around = [each for each in self._packages if path.startswith(each)]
        return max(around, key=len, default=f"{os.path.dirname(path)}/")

    @cached_property
    def _packages(self) -> list[str]:
        return [f"{os.path.dirname(each.absolute)}/" for each in self._files.of_kind("ros-package")]

    @memo
    def _is_used(self, asked: tuple[str, str]) -> bool:
        """Whether anything says the name of a class, but for its own files where they only define it."""
        name, stem = asked
        if len(self._texts) > _MOST:
            return True
        written = re.escape(name)
        word = re.compile(rf"(?<!\w){written}(?!\w)(?![ \t]*;)")
        own = re.compile(
            rf"(?<![\w~])(?<!class )(?<!struct )(?<!explicit ){written}(?!\w)(?!{_DEFINED})|{_MADE}{written}[ \t]*[({{]"
            rf"|{_BASE}{written}(?!\w)|{_CALLED}{written}::(?!{written}\b)\w+[ \t]*\(",
            re.M,
        )
        return any(
            (own if _stem(path) == stem else word).search(text) for path, text in self._texts.items() if name in text
        ) or any(name in text for text in self._naming)

    @cached_property
    def _texts(self) -> dict[str, str]:
        """The C++ files of the tree, without comments and names of headers."""
        tree = self._files.tree
        paths = [path for path in tree.paths if path.endswith(CPP)]
        if len(paths) > _MOST:
            return dict.fromkeys(paths, "")
        kept = (path for path in paths if not self._is_of_tests(os.path.abspath(path)))
        return {os.path.abspath(path): _REMARK.sub("", tree.head(path, _SIZE)) for path in kept}

    def _is_of_tests(self, path: str) -> bool:
        """Whether a file of a package is in a folder of tests, which make what no robot has."""
        return _TESTS.search(path, len(self._package(path)) - 1) is not None

    @cached_property
    def _naming(self) -> list[str]:
        """What may name a class to load it."""
        return [*(each.text for each in self._files.of_kind(*_NAMING)), *self._files.tree.pages(_PLUGINS, _SIZE)]


def _around(place: Span) -> str | None:
    """The class that a place is in, where its definition begins at the start of a line."""
    heads, ends = place.source.once(_around, lambda: _heads(place.source.text))
    at = bisect_right(heads, (place.start, place.start))
    while at and heads[at - 1][1] > place.start:
        at -= 1
    if not at:
        return None
    _, after, name = heads[at - 1]
    end = bisect_left(ends, after)
    return name if end == len(ends) or ends[end] >= place.start else None


def _heads(text: str) -> tuple[list[tuple[int, int, str]], list[int]]:
    """Where definitions of classes and their functions begin, up to where, and of which class; and where they end."""
    found = (each for pattern in (_METHOD, _CLASS) for each in pattern.finditer(text))
    return sorted((*each.span(), each["name"]) for each in found), [each.start() for each in _END.finditer(text)]


def _stem(path: str) -> str:
    return os.path.basename(path).partition(".")[0]
