"""How Fast DDS reads the text of an element (XMLElementParser.cpp; TinyXML-2 underneath)."""

from __future__ import annotations

import re

from bringup_lint.addresses import quad
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.schema import Item
from bringup_lint.model.xml import Element
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_NUMBER = regex(r"[ \t\n\v\f\r]*([+-]?)(0[xX][0-9a-fA-F]+|[0-9]+)")
_OCTET = r"(?:0+|0*[1-9a-fA-F][0-9a-fA-F]?)"
_OCTETS = regex(rf"[ \t\n\v\f\r]*\+?(?:0[xX])?{_OCTET}(?:\.{_OCTET})*")
_GUID = regex(r"[0-9a-fA-F]{1,2}(?:\.[0-9a-fA-F]{1,2}){11}")
_VARIABLE = regex(r"\$\{[^}]{0,400}\}")
LIMITS = {"uint8": 255, "uint16": 65535, "int16": 32767}


def first_text(element: Element) -> Located | None:
    """The text that TinyXML-2 gives: only when it is the first thing inside, untrimmed; a comment before it
    hides it."""
    run = next((run for run in element.texts if run.strip()), None)
    if run is None:
        return None
    before = element.span.source.text[element.tag.end : run.span.start].strip()
    return run if before in ("", "<![CDATA[") else None


def hidden_by_comment(element: Element) -> bool:
    """Whether there is text, but something is before it."""
    return first_text(element) is None and any(run.strip() for run in element.texts)


def fault_of(item: Item, text: str) -> Fault | None:
    """What the library has against a text; None when it takes it, or when it depends on a variable."""
    if _VARIABLE.search(text):
        return None
    if item.type in _CHECKS:
        return _CHECKS[item.type](item, text)
    return None


def _bool(item: Item, text: str) -> Fault | None:
    return None if text in ("true", "false") or _NUMBER.match(text) else Fault(Code.BOOL)


def _enum(item: Item, text: str) -> Fault | None:
    return None if text in item.words else Fault(Code.ENUM)


def _flags(item: Item, text: str) -> Fault | None:
    words = [word.strip() for word in text.split("|")]
    return None if all(word in item.words for word in words) else Fault(Code.ENUM)


def _number(item: Item, text: str) -> Fault | None:
    match = _NUMBER.match(text)
    if match is None:
        return Fault(Code.NUMBER)
    value = int(match[2][:30], 0) if not match[2].startswith("0") or "x" in match[2].lower() else int(match[2][:30])
    if match[1] == "-":
        value = -value
    if item.type in ("uint8", "uint16", "natural") and match[1] == "-":
        return Fault(Code.NUMBER, "negative")
    if item.type in LIMITS and value > LIMITS[item.type]:
        return Fault(Code.NUMBER, f"more than {LIMITS[item.type]}")
    if item.type == "positive" and value == 0:
        return Fault(Code.NUMBER, "zero")
    if item.type == "atleast-1" and value < -1:
        return Fault(Code.NUMBER, "below -1")
    rest = text[match.end() :].strip()
    return Fault(Code.NUMBER, rest, False) if rest else None


def _duration_part(item: Item, text: str) -> Fault | None:
    if text in item.words:
        return None
    return _number(item, text)


def _address4(item: Item, text: str) -> Fault | None:
    if max(quad(text.strip()) or (0,)) > 255:
        return Fault(Code.ADDRESS, "a number above 255")
    return Fault(Code.ADDRESS, "a port or network") if re.search(r"[0-9][:/]", text) else None


def _address6(item: Item, text: str) -> Fault | None:
    return Fault(Code.ADDRESS, "an IPv4 address") if quad(text.strip()) else None


def _octets(item: Item, text: str) -> Fault | None:
    return None if _OCTETS.fullmatch(text) else Fault(Code.VALUE, "octets such as 0a.1b")


def _guid(item: Item, text: str) -> Fault | None:
    return None if _GUID.fullmatch(text.strip()) else Fault(Code.VALUE, "twelve octets such as 44.53.00")


_CHECKS = {
    "bool": _bool,
    "enum": _enum,
    "flags": _flags,
    "number": _number,
    "natural": _number,
    "positive": _number,
    "uint8": _number,
    "uint16": _number,
    "int16": _number,
    "atleast-1": _number,
    "duration": _duration_part,
    "address4": _address4,
    "address6": _address6,
    "octets": _octets,
    "octets?": _octets,
    "guid": _guid,
}
