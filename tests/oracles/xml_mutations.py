"""Breeds XML files with one to three slips such as people make: names, values, tags, places, markup."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator

_NAME = re.compile(r"(?<=[<\s])[A-Za-z_]\w*(?=[\s=/>])")
_TEXT = re.compile(r">([^<>\n]+)<")
_VALUE = re.compile(r'="([^"\n]*)"')
_LEAF = re.compile(r"\n[ \t]*<(\w+)[^<>\n]*(?:/>|>[^<\n]*</\1>)")
_BLOCK = re.compile(r"\n([ \t]*)<(\w+)[^<>/\n]*>\n(?:.*\n)*?\1</\2>")
_TAG = re.compile(r"</?\w[^<>\n]*>")


def mutants(text: str, values: list[str], count: int, seed: int) -> Iterator[str]:
    """``count`` different files; every value of the list is tried in many places."""
    draw = random.Random(seed)
    seen = {text}
    while len(seen) <= count:
        mutant = text
        for _ in range(draw.choice((1, 1, 1, 2, 3))):
            mutant = draw.choice(SLIPS)(mutant, draw, values)
        if mutant not in seen:
            seen.add(mutant)
            yield mutant


def _pick(pattern: re.Pattern[str], text: str, draw: random.Random) -> re.Match[str] | None:
    found = list(pattern.finditer(text))
    return draw.choice(found) if found else None


def _replace(text: str, match: re.Match[str] | None, new: str, group: int = 0) -> str:
    return text if match is None else text[: match.start(group)] + new + text[match.end(group) :]


def _misspelt(word: str, draw: random.Random) -> str:
    at = draw.randrange(len(word))
    return draw.choice(
        (word[:at] + word[at + 1 :], word.swapcase(), word.lower(), word[: at + 1], word + "s", word.upper())
    )


def rename(text: str, draw: random.Random, values: list[str]) -> str:
    """Misspell a name everywhere, so that the tags still match."""
    match = _pick(_NAME, text, draw)
    if match is None:
        return text
    new = _misspelt(match[0], draw)
    return re.sub(rf"(?<=[</\s]){match[0]}(?=[\s=/>])", new, text) if new else text


def change_text(text: str, draw: random.Random, values: list[str]) -> str:
    return _replace(text, _pick(_TEXT, text, draw), draw.choice(values), 1)


def spoil_text(text: str, draw: random.Random, values: list[str]) -> str:
    match = _pick(_TEXT, text, draw)
    return text if match is None else _replace(text, match, _misspelt(match[1], draw), 1)


def pad_text(text: str, draw: random.Random, values: list[str]) -> str:
    match = _pick(_TEXT, text, draw)
    pads = (" {} ", "\n{}\n", "<!-- c -->{}", "{}<!-- c -->", "<![CDATA[{}]]>", "{}<b/>", "&#32;{}")
    return text if match is None else _replace(text, match, draw.choice(pads).format(match[1]), 1)


def change_value(text: str, draw: random.Random, values: list[str]) -> str:
    return _replace(text, _pick(_VALUE, text, draw), draw.choice(values).replace('"', ""), 1)


def drop_leaf(text: str, draw: random.Random, values: list[str]) -> str:
    return _replace(text, _pick(_LEAF, text, draw), "")


def repeat_leaf(text: str, draw: random.Random, values: list[str]) -> str:
    match = _pick(_LEAF, text, draw)
    return text if match is None else text[: match.end()] + match[0] + text[match.end() :]


def move_leaf(text: str, draw: random.Random, values: list[str]) -> str:
    match = _pick(_LEAF, text, draw)
    if match is None:
        return text
    rest = _replace(text, match, "")
    target = _pick(_LEAF, rest, draw)
    return rest if target is None else rest[: target.end()] + match[0] + rest[target.end() :]


def drop_block(text: str, draw: random.Random, values: list[str]) -> str:
    return _replace(text, _pick(_BLOCK, text, draw), "")


def repeat_block(text: str, draw: random.Random, values: list[str]) -> str:
    match = _pick(_BLOCK, text, draw)
    return text if match is None else text[: match.end()] + match[0] + text[match.end() :]


def add_attribute(text: str, draw: random.Random, values: list[str]) -> str:
    match = _pick(re.compile(r"<\w+(?=[\s/>])"), text, draw)
    extra = draw.choice((' name="x"', ' xmlns:a="urn:a"', ' bogus="1"', ' Id="any"', " flag", " a=b"))
    return text if match is None else text[: match.end()] + extra + text[match.end() :]


def add_markup(text: str, draw: random.Random, values: list[str]) -> str:
    match = _pick(_TAG, text, draw)
    extra = draw.choice(
        ("<!-- a -- b -->", "text", "&", "&amp;", "<", "<?robot?>", "<bogus/>", "]]>", "<a:b/>", "</x>")
    )
    return text if match is None else text[: match.end()] + extra + text[match.end() :]


def drop_tag(text: str, draw: random.Random, values: list[str]) -> str:
    return _replace(text, _pick(_TAG, text, draw), "")


def change_root(text: str, draw: random.Random, values: list[str]) -> str:
    root = re.search(r"(?<=<)\w+(?=[^<>]*>(?:.|\n)*</\w+>\s*$)", text)
    names = [name for name in re.findall(r"<(\w+)", text)[:1] if name]
    if root is None or not names:
        return text
    new = draw.choice((names[0].upper(), names[0].lower(), names[0].title(), "config", names[0][:-1]))
    return re.sub(rf"(?<=[</]){names[0]}(?=[\s>])", new, text)


def add_prolog(text: str, draw: random.Random, values: list[str]) -> str:
    return draw.choice(("<!-- first -->\n", "\n", "<!DOCTYPE x>\n", "\ufeff", "text\n")) + text


SLIPS = (
    rename,
    rename,
    change_text,
    change_text,
    change_text,
    spoil_text,
    pad_text,
    change_value,
    change_value,
    drop_leaf,
    repeat_leaf,
    move_leaf,
    drop_block,
    repeat_block,
    add_attribute,
    add_markup,
    drop_tag,
    change_root,
    add_prolog,
)
