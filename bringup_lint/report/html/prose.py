"""The documentation of a rule as HTML: the Markdown that docstrings use."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.pattern import regex
from bringup_lint.report.docs import LOG_LINES
from bringup_lint.report.docs import sections
from bringup_lint.report.html.markup import lines
from bringup_lint.report.html.markup import text
from bringup_lint.report.model import RuleDoc

_FENCED = regex(r"^ *```.*\n((?:.*\n)*?) *```$", re.MULTILINE)
_INLINE = regex(r"`(?P<code>[^`]+)`|\*\*(?P<bold>.+?)\*\*|\[(?P<name>[^\]]+)\]\((?P<uri>https://[^)\s]+)\)")


def prose(doc: RuleDoc) -> str:
    """The title, and each section below its heading."""
    parts = [f"<h4>{text(doc.title)}</h4>"]
    for heading, body in sections(doc.docstring).items():
        parts.append(f"<h5>{text(heading)}</h5>{''.join(_blocks(body))}")
    if doc.symptoms:
        parts.append(f"<h5>{LOG_LINES}</h5><pre>{lines(chr(10).join(doc.symptoms))}</pre>")
    elif doc.silent:
        parts.append(f"<h5>{LOG_LINES}</h5><p>None: {text(doc.silent)}.</p>")
    return "".join(parts)


def _blocks(body: str) -> Iterator[str]:
    for number, part in enumerate(_FENCED.split(body)):
        if number % 2:
            yield f"<pre>{lines(part)}</pre>"
            continue
        for block in re.split(r"\n\s*\n|\n(?=- )", part.strip()):
            if block.startswith("- "):
                yield f"<ul><li>{_inline(block[2:])}</li></ul>"
            elif block:
                yield f"<p>{_inline(block)}</p>"


def _inline(words: str) -> str:
    words = " ".join(words.split())
    done, said = 0, []
    for match in _INLINE.finditer(words):
        said += [text(words[done : match.start()]), _marked(match)]
        done = match.end()
    return "".join((*said, text(words[done:])))


def _marked(match: re.Match[str]) -> str:
    if match["code"]:
        return f"<code>{text(match['code'])}</code>"
    if match["bold"]:
        return f"<strong>{text(match['bold'])}</strong>"
    return f'<a href="{text(match["uri"])}" rel="noreferrer" target="_blank">{text(match["name"])}</a>'
