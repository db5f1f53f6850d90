"""What a rule file says of itself, read from its text."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.type_names import Any

_ASKED = regex(r"\brobot\.(\w+)")
END_OF_DOC = '\n"""\n'


class Described(NamedTuple):
    """The metadata of a rule that is not imported."""

    severity: str
    options: dict[str, Any]
    """The other arguments of the decorator."""
    title: str
    asks: tuple[str, ...] = ()
    """What of the robot the file names: ``nodes`` for ``robot.nodes``, in the order of the alphabet."""


def described(text: str) -> Described:
    """The arguments of the decorator and the title. Raises ValueError for a file of an unusual form."""
    import ast

    decorator = text.index("\n@rule(")
    try:
        expression = ast.parse(text[decorator + 2 : text.index("\ndef ", decorator)], mode="eval").body
    except SyntaxError as error:
        raise ValueError(str(error)) from error
    if not isinstance(expression, ast.Call) or len(expression.args) != 1:
        raise ValueError("a decorator of an unusual form")
    severity = ast.literal_eval(expression.args[0])
    options = {str(option.arg): ast.literal_eval(option.value) for option in expression.keywords}
    asks = tuple(sorted(set(_ASKED.findall(text, text.index(END_OF_DOC)))))
    doc = documentation(text)
    if missing_headings(doc):
        raise ValueError("a file without all headings")
    return Described(severity, options, doc.strip().partition("\n")[0].rstrip("."), asks)


def missing_headings(doc: str) -> list[str]:
    """The sections that the documentation of a rule lacks."""
    from bringup_lint.report.docs import HEADINGS

    return [heading for heading in HEADINGS if f"\n## {heading}\n" not in doc]


def documentation(text: str) -> str:
    """The docstring of a rule file. Raises ValueError for a file of an unusual form."""
    import ast

    try:
        doc = ast.literal_eval(text[: text.index(END_OF_DOC) + 4])
    except SyntaxError as error:
        raise ValueError(str(error)) from error
    if not isinstance(doc, str):
        raise ValueError("a file without documentation")
    return doc
