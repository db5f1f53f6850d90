"""Unit names: their parts, their characters, the escaping of paths; systemd.unit(5), systemd-escape(1)."""

from __future__ import annotations

from bringup_lint.facts.systemd.directives import SECTION_OF_TYPE
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_CHARACTERS = regex(r"[A-Za-z0-9:_.\\@-]+")
_PLAIN = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789:_.")
_ESCAPED = regex(r"\\x([0-9a-fA-F]{2})")
MAX_LENGTH = 255


class UnitName(NamedTuple):
    prefix: str
    instance: str | None
    """None without ``@``, empty for a template."""
    type: str

    @property
    def is_template(self) -> bool:
        return self.instance == ""


def split_name(unit: str) -> UnitName:
    """``robot@front.service`` to its parts."""
    stem, _, kind = unit.rpartition(".")
    prefix, at, instance = stem.partition("@")
    return UnitName(prefix, instance if at else None, kind)


def is_unit_name(text: str) -> bool:
    """Whether systemd takes the text as the name of a unit, an instance or a template."""
    stem, dot, kind = text.rpartition(".")
    if not dot or not stem or len(text) > MAX_LENGTH or kind not in SECTION_OF_TYPE:
        return False
    return stem[0] != "@" and _CHARACTERS.fullmatch(stem) is not None


def escape(text: str) -> str:
    """A string as it is in a unit name: ``/`` becomes ``-``, other characters become ``\\xNN``."""
    out = []
    for at, char in enumerate(text):
        if char == "/":
            out.append("-")
        elif char in _PLAIN and not (at == 0 and char == "."):
            out.append(char)
        else:
            out.extend(f"\\x{byte:02x}" for byte in char.encode("utf-8", "surrogateescape"))
    return "".join(out)


def unescape(text: str) -> str:
    """The string that an escaped part of a unit name stands for."""
    text = text.replace("-", "/")
    if "\\x" not in text:
        return text
    raw = _ESCAPED.sub(lambda found: chr(int(found[1], 16)), text)
    try:
        return raw.encode("latin-1").decode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        return raw


def escape_path(path: str) -> str:
    """``/dev/robot/front-lidar`` to ``dev-robot-front\\x2dlidar``; the root folder is ``-``."""
    parts = [part for part in path.split("/") if part not in ("", ".")]
    return escape("/".join(parts)) if parts else "-"


def unescape_path(name: str) -> str:
    """``dev-robot-front\\x2dlidar`` to ``/dev/robot/front-lidar``."""
    return "/" if name == "-" else "/" + unescape(name).lstrip("/")
