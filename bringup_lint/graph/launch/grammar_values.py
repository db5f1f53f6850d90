"""The values of attributes as launch's front ends convert them: XML guesses from the text, YAML has typed them."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.parsers.launch_frontend.template import Refused
from bringup_lint.parsers.launch_frontend.template import template
from bringup_lint.parsers.launch_yaml import resolved

TYPES: dict[str, tuple[type | None, bool]] = {
    "str": (str, False),
    "bool": (bool, False),
    "float": (float, False),
    "int": (int, False),
    "list_of_str": (str, True),
    "list_of_bool": (bool, True),
    "list_of_float": (float, True),
    "list_of_int": (int, True),
    "yaml": (None, False),
}
"""The words for the type of a parameter: type of the value or of its items, and whether it is a list."""
_SCALARS = (int, float, bool, str)
_NAMES: dict[type | None, str] = {
    str: "text",
    bool: "true or false",
    float: "a number with a decimal point",
    int: "a whole number",
}
_OF_YAML = {"bool": bool, "truth": bool, "integer": int, "number": float, "seconds": float}


def value_problem(kind: str, value: object, form: str, *, separated: bool = False) -> str | None:
    """Why launch refuses an attribute of a type from the grammar, else None."""
    if separated:
        return "takes no list"
    if form != "xml":
        return _yaml_problem(kind, value)
    return _xml_problem(kind, str(value))


def _yaml_problem(kind: str, value: object) -> str | None:
    wanted = _OF_YAML.get(kind, str)
    if not isinstance(value, (str, wanted)):
        return f"must be {_NAMES[wanted]}, not {_shown(value)}" + (": quote it" if wanted is str else "")
    if isinstance(value, str):
        return _text_problem(kind, value)
    negative = isinstance(value, float) and value < 0
    return "must not be negative" if kind == "seconds" and negative else None


def _xml_problem(kind: str, text: str) -> str | None:
    if kind in ("bool", "truth"):
        found = True if text in ("0", "1") else resolved(text) if text else ""
        if isinstance(found, bool):
            return None
        return _text_problem(kind, text) if isinstance(found, str) else "must be true or false"
    if kind in ("number", "seconds"):
        try:
            number = float(text)
        except ValueError:
            return _text_problem(kind, text)
        return "must not be negative" if kind == "seconds" and number < 0 else None
    if kind == "type":
        found = resolved(text)
        return None if isinstance(found, str) and found in TYPES else f"must be one of {', '.join(TYPES)}"
    return _text_problem(kind, text)


def _text_problem(kind: str, text: str) -> str | None:
    """What is wrong with text that could not be converted."""
    if kind == "seconds":
        return "must be a number, without substitutions"
    if kind == "shutdown":
        return None if text == "shutdown" else "must be 'shutdown'"
    if kind == "type":
        return None if text in TYPES else f"must be one of {', '.join(TYPES)}"
    if kind in ("number", "truth") and not has_substitution(text):
        return "must be a number" if kind == "number" else "must be true or false"
    return None


def has_substitution(text: str) -> bool:
    """Whether a text is not known before launch runs; True also for one that launch cannot read."""
    try:
        return bool(template(text).used)
    except Refused:
        return True


def parameter_problem(value: object, kind: str, form: str, separator: str | None) -> str | None:
    """Why launch refuses the value of a parameter; ``kind`` is its ``type`` attribute."""
    if kind not in TYPES:
        return None
    wanted, many = TYPES[kind]
    if separator is not None:
        if wanted is not None and not many:
            return f"must be {_NAMES[wanted]}, not a list"
        if not separator:
            return "has an empty separator"
        parts = str(value).split(separator)
        return _items_problem([_converted(part, wanted) for part in parts], wanted)
    if form == "xml":
        value = _list_or_text(str(value)) if many else _converted(str(value), wanted)
    return _given_problem(value, wanted, many)


def _list_or_text(text: str) -> object:
    return resolved(text) if text else text


def _converted(text: str, wanted: type | None) -> object:
    """A text as the XML front end converts it; the text itself when it is none of the type."""
    if wanted is None or wanted is bool:
        if wanted is bool and text in ("0", "1"):
            return text == "1"
        return resolved(text) if text else text
    if wanted in (int, float):
        try:
            return wanted(text)
        except ValueError:
            return text
    return text


def _given_problem(value: object, wanted: type | None, many: bool) -> str | None:
    if isinstance(value, list):
        if wanted is not None and not many:
            return f"must be {_NAMES[wanted]}, not a list"
        return _items_problem(value, wanted)
    if many:
        return "must be a list"
    if not isinstance(value, _SCALARS):
        return f"is {_shown(value)}: launch takes numbers, truth values, text and lists of one of them"
    if wanted is None or type(value) is wanted or (wanted is int and isinstance(value, int)):
        return None
    if isinstance(value, str) and has_substitution(value):
        return None
    return f"must be {_NAMES[wanted]}"


def _items_problem(items: list[object], wanted: type | None) -> str | None:
    """Lists are of one type; text with substitutions may be among others."""
    fixed = [item for item in items if not (isinstance(item, str) and has_substitution(item))]
    if not all(isinstance(item, _SCALARS) for item in fixed):
        return "is a list of lists, maps or nothing: launch takes lists of numbers, truth values or text"
    if wanted is not None:
        good = all(type(item) is wanted for item in fixed)
        return None if good else f"must be a list of which every item is {_NAMES[wanted]}"
    return None if len({type(item) for item in fixed}) < 2 else "is a list of several types"


def _shown(value: object) -> str:
    names: dict[type, str] = {bool: "a truth value", int: "a whole number", float: "a number", type(None): "nothing"}
    names |= {list: "a list", dict: "a map"}
    return names.get(type(value), "of another type")


def texts_of(value: object, separator: str | None) -> Iterator[str]:
    """The texts in the value of a parameter in which launch looks for substitutions."""
    if separator:
        yield from str(value).split(separator)
    elif isinstance(value, list):
        yield from (item for item in value if isinstance(item, str))
