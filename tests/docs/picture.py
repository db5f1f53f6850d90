"""Draws coloured terminal output as an SVG picture, readable on light and on dark pages."""

from __future__ import annotations

import re
from html import escape

CELL, LINE, MARGIN = 8.4, 19, 20
COLOURS = {"91": "#ff7b72", "33": "#e3b341", "36": "#39c5cf", "94": "#79c0ff", "32": "#56d364"}
STYLES = {"1": "font-weight:700", "2": "opacity:.65"}
HEAD = """\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height}" \
width="{width:.0f}" height="{height}" role="img" aria-label="{title}">
<rect width="100%" height="100%" rx="8" fill="#0d1117"/>
<g font-family="ui-monospace,SFMono-Regular,Menlo,Consolas,'DejaVu Sans Mono',monospace" font-size="14" \
fill="#e6edf3" xml:space="preserve">
"""


def picture(output: str, command: str, width: int = 80) -> str:
    """The SVG of a command and its coloured output."""
    lines = [f"\x1b[2m$\x1b[0m \x1b[1m{command}\x1b[0m", "", *output.rstrip("\n").split("\n")]
    size = {"width": width * CELL + 2 * MARGIN, "height": len(lines) * LINE + 2 * MARGIN}
    rows = "\n".join(_row(line, number) for number, line in enumerate(lines) if line)
    return HEAD.format(title=escape(command), **size) + rows + "\n</g>\n</svg>\n"


def _row(line: str, number: int) -> str:
    y = MARGIN + (number + 1) * LINE - 5
    style, column, spans = "", 0, []
    for part in re.split(r"(\x1b\[[\d;]*m)", line):
        if part.startswith("\x1b"):
            codes = part[2:-1].split(";")
            styles = [f"fill:{COLOURS[code]}" if code in COLOURS else STYLES.get(code, "") for code in codes]
            style = ";".join(filter(None, styles))
        else:
            words = re.finditer(r"\S+(?: \S+)*", part)
            spans += [_span(each[0], MARGIN + (column + each.start()) * CELL, style) for each in words]
        column += 0 if part.startswith("\x1b") else len(part)
    return f'<text y="{y}">{"".join(spans)}</text>'


def _span(text: str, x: float, style: str) -> str:
    styled = f' style="{style}"' if style else ""
    return f'<tspan x="{x:.1f}" textLength="{len(text) * CELL:.1f}"{styled}>{escape(text)}</tspan>'
