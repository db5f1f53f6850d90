"""Comments that silence findings: ``bringup-lint: ignore[...]`` and ``bringup-lint: ignore-file[...]``."""

from __future__ import annotations

from bringup_lint.pattern import regex

MARK = "bringup-lint:"
IGNORE = regex(r"bringup-lint:[ \t]*(?P<what>ignore(?:-file)?)[ \t]*\[(?P<names>[^\[\]\n]*)\]")
OPENS = ("#", ";", "//", "<!--")
_REST = regex(r"(?:[^\r\n-]|-(?!->))*")


def without_marks(text: str) -> str:
    """A text in which blanks are written over such comments: no rule may take what they say for what the file says.

    Offsets stay. A comment of XML keeps its signs, which may be on other lines.
    """
    if MARK not in text:
        return text
    kept: list[str] = []
    at = 0
    for match in IGNORE.finditer(text):
        if match.start() < at:
            continue
        before = text[max(at, text.rfind("\n", at, match.start()) + 1) : match.start()].rstrip(" \t")
        opens = next((sign for sign in OPENS if before.endswith(sign)), None)
        rest = _REST.match(text, match.end())
        if opens is None or rest is None:
            continue
        start = match.start() if opens == "<!--" else text.rindex(opens, at, match.start())
        kept += (text[at:start], " " * (rest.end() - start))
        at = rest.end()
    return "".join((*kept, text[at:]))
