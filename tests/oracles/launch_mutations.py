"""Makes broken and harmless variants of XML and YAML launch files: what people mistype, forget and copy."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from collections.abc import Iterator

_SITES = {
    "xml": {
        "tag": re.compile(r"(?<=<)/?(?!launch\b)[a-z]\w*(?:-\w+)*(?=[\s/>])"),
        "attribute": re.compile(r"(?<=\s)[a-z][\w-]*(?==\")"),
        "pair": re.compile(r"\s[a-z][\w-]*=\"[^\"]*\""),
        "value": re.compile(r"(?<==\")[^\"]*(?=\")"),
        "end": re.compile(r"/?>"),
    },
    "yaml": {
        "tag": re.compile(r"(?<=- )[a-z]\w*(?=:\n)"),
        "attribute": re.compile(r"(?<=  )[a-z]\w*(?=:)"),
        "pair": re.compile(r"\n\s+[a-z]\w*: [^\n]+"),
        "value": re.compile(r"(?<=: )[^\n]+"),
        "end": re.compile(r"\n"),
    },
}
_VALUES = [
    "soon",
    "3",
    "-1.0",
    "true",
    "maybe",
    "[1, 2]",
    "[1, a]",
    "[[1], [2]]",
    "null",
    "2024-01-01",
    "it's",
    "",
    "1e3",
]
_NAMES = ["type", "ns", "machine", "nam", "values", "default_value", "package", "executable", "condition", "args", "to"]
_SUBSTITUTIONS = [
    "$(var)",
    "$(var robot mode more)",
    "$(find-pkg-shar demo)",
    "$(find demo)",
    "$(arg robot)",
    "$(env)",
    "$(var  robot)",
    "$( var robot)",
    "$(var robot",
    "$(var robot )",
    "$(dirname here)",
    "$(eval 1 + 2)",
    "$(eval '1 + 2')",
    "$(eval $(var robot)=='x')",
    "$(if $(var robot) a b)",
    "$(equals a b)",
    "$(exec-in-pkg driver)",
    "$(command 'ls -l' warn)",
    "$$(var robot)",
    "\\$(var robot)",
    "$(anon base)",
    "$",
    "$()",
    "$(and true)",
    "a\\'b",
]
Change = Callable[[str, str, random.Random], str]


def _mistyped(word: str, chance: random.Random) -> str:
    at = chance.randrange(len(word))
    return chance.choice(
        [word[:at] + word[at + 1 :], word[:at] + word[at] + word[at:], word[:at] + "x" + word[at + 1 :]]
    )


def _at(name: str, change: Callable[[str, random.Random], str]) -> Change:
    """A change of one place of a kind."""

    def act(text: str, form: str, chance: random.Random) -> str:
        places = list(_SITES[form][name].finditer(text))
        place = chance.choice(places)
        return text[: place.start()] + change(place[0], chance) + text[place.end() :]

    return act


def _rename(text: str, form: str, chance: random.Random) -> str:
    """A tag under another name, in XML with its end."""
    names = sorted({word.lstrip("/") for word in _SITES[form]["tag"].findall(text)})
    old = chance.choice(names)
    new = _mistyped(old, chance) if chance.random() < 0.6 else chance.choice([*names, "rosparam", "test", "machine"])
    return re.sub(rf"(?<=[</ ]){old}(?=[\s/>:])", new, text)


def _more(text: str, form: str, chance: random.Random) -> str:
    name, value = chance.choice(_NAMES), chance.choice(_VALUES)
    place = chance.choice(list(_SITES[form]["pair"].finditer(text)))
    blanks = re.match(r"\s+", place[0])
    added = f' {name}="{value}"' if form == "xml" else f"{blanks[0] if blanks else ' '}{name}: {value}"
    return text[: place.end()] + added + text[place.end() :]


def _comment(text: str, form: str, chance: random.Random) -> str:
    place = chance.choice(list(_SITES[form]["end"].finditer(text)))
    mark = chance.choice(["<!-- a -- b -->", "<!-- a - b -->", "<!--->"]) if form == "xml" else "  # a -- b\n"
    return text[: place.end()] + mark + text[place.end() :]


def _move(text: str, form: str, chance: random.Random) -> str:
    """A line somewhere else."""
    lines = text.split("\n")
    line = lines.pop(chance.randrange(1, len(lines) - 1))
    lines.insert(chance.randrange(1, len(lines)), line)
    return "\n".join(lines)


CHANGES: list[Change] = [
    _at("attribute", _mistyped),
    _at("attribute", lambda old, chance: chance.choice(_NAMES)),
    _at("pair", lambda old, chance: ""),
    _at("value", lambda old, chance: chance.choice(_VALUES)),
    _at("value", lambda old, chance: chance.choice(_SUBSTITUTIONS)),
    _at("value", lambda old, chance: f"{old} {chance.choice(_SUBSTITUTIONS)}"),
    _at("value", lambda old, chance: _mistyped(old, chance) if old else "x"),
    _rename,
    _more,
    _comment,
    _move,
]


def variants(text: str, form: str, count: int, seed: int) -> Iterator[str]:
    chance = random.Random(seed)
    for at in range(count):
        yield CHANGES[at % len(CHANGES)](text, form, chance)
