"""The arithmetic of shell scripts, for what can be told without running them."""

from __future__ import annotations

from collections.abc import Mapping

from bringup_lint.pattern import regex

_TOKEN = regex(r"\s*(?:(\d{1,9})|(\$?\{?[A-Za-z_]\w*\}?)|([-+*/%()]))")
_NAME = regex(r"\$(?:\{(?P<braced>[A-Za-z_]\w*)(?::-(?P<default>[^}]{0,400}))?\}|(?P<plain>[A-Za-z_]\w*))\Z")
_LIMIT = 200


def evaluate(text: str, variables: Mapping[str, str]) -> int | None:
    """The number that ``42``, ``$NAME``, ``${NAME:-42}`` or ``$((7400 + 250 * NAME))`` stands for.

    None when it is not a number, or when a name has no value.
    """
    text = text.strip().strip("\"'")
    if text.isdecimal() and len(text) < 10:
        return int(text)
    name = _NAME.match(text)
    if name:
        value = variables.get(name["braced"] or name["plain"], name["default"])
        return int(value) if value is not None and value.isdecimal() and len(value) < 10 else None
    if text.startswith("$((") and text.endswith("))") and len(text) < _LIMIT:
        tokens = _tokens(text[3:-2], variables)
        return _Sum(tokens).value() if tokens is not None else None
    return None


def _tokens(text: str, variables: Mapping[str, str]) -> list[str] | None:
    """Numbers, signs and brackets, with names replaced by their numbers; None when anything else is among them."""
    found: list[str] = []
    at = 0
    while at < len(text.rstrip()):
        match = _TOKEN.match(text, at)
        if match is None:
            return None
        word = match[1] or match[3]
        if word is None:
            word = variables.get(match[2].strip("${}"), "")
            if not word.isdecimal() or len(word) > 9:
                return None
        found.append(word)
        at = match.end()
    return found


class _Sum:
    """A recursive descent over sums, products and brackets."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens = tokens

    def value(self) -> int | None:
        if not self.tokens:
            return None
        try:
            found = self.sum()
        except (IndexError, ValueError, ZeroDivisionError):
            return None
        return found if not self.tokens else None

    def sum(self) -> int:
        found = self.product()
        while self.tokens and self.tokens[0] in ("+", "-"):
            sign = 1 if self.tokens.pop(0) == "+" else -1
            found += sign * self.product()
        return found

    def product(self) -> int:
        found = self.factor()
        while self.tokens and self.tokens[0] in ("*", "/", "%"):
            operator, other = self.tokens.pop(0), self.factor()
            found = found * other if operator == "*" else found // other if operator == "/" else found % other
        return found

    def factor(self) -> int:
        token = self.tokens.pop(0)
        if token == "(":
            found = self.sum()
            if self.tokens.pop(0) != ")":
                raise ValueError(token)
            return found
        return int(token)
