"""``${NAME}``, ``${NAME:-word}``, ``${NAME:+word}`` and ``${NAME:?word}`` as Cyclone DDS expands them.

``$NAME`` without braces stays as it is (``ddsrt_expand_vars``).
"""

from __future__ import annotations

from collections.abc import Mapping

MAX_DEPTH = 20


class ExpansionError(ValueError):
    """The library refuses the text: an open brace, or ``:?`` with an unset variable."""


class UnknownVariable(LookupError):
    """The result depends on a variable that nobody knows."""


def expand(text: str, environment: Mapping[str, str] | None, depth: int = 0) -> str:
    """The text with variables replaced; ``environment`` None means that no variable is known.

    Raises ExpansionError or UnknownVariable.
    """
    if "${" not in text:
        return text
    if depth >= MAX_DEPTH:
        raise ExpansionError("too deeply nested")
    parts: list[str] = []
    at = 0
    while True:
        start = text.find("${", at)
        if start == -1:
            return "".join((*parts, text[at:]))
        parts.append(text[at:start])
        name, operator, word, at = _braces(text, start + 2)
        parts.append(_value(name, operator, word, environment, depth))


def _braces(text: str, start: int) -> tuple[str, str, str, int]:
    end = start
    while end < len(text) and text[end] not in ":}":
        end += 1
    name = text[start:end]
    if end == len(text):
        raise ExpansionError("the brace is not closed")
    if text[end] == "}":
        return name, "", "", end + 1
    operator = text[end + 1 : end + 2]
    if operator not in ("-", "+", "?"):
        raise ExpansionError(f"':{operator}' is no operator")
    word = at = end + 2
    nested = 0
    while at < len(text) and (text[at] != "}" or nested):
        if text[at] == "{":
            nested += 1
        elif text[at] == "}":
            nested -= 1
        elif text[at] == "\\":
            at += 1
        at += 1
    if at >= len(text):
        raise ExpansionError("the brace is not closed")
    return name, operator, text[word:at], at + 1


def _value(name: str, operator: str, word: str, environment: Mapping[str, str] | None, depth: int) -> str:
    if environment is None:
        raise UnknownVariable(name)
    value = environment.get(name, "")
    if operator == "-":
        return value or expand(word, environment, depth + 1)
    if operator == "+":
        return expand(word, environment, depth + 1) if value else ""
    if operator == "?" and not value:
        raise ExpansionError(f"{name} is not set")
    return value
