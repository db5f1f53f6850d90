"""Text of untrusted files as HTML and as JSON inside HTML."""

from __future__ import annotations

import json
from base64 import b64encode
from hashlib import sha256
from html import escape
from typing import Any

from bringup_lint.report.columns import printable
from bringup_lint.report.unicode import harmless


def text(value: object) -> str:
    """Escaped for elements and quoted attributes; control and direction characters are shown as signs."""
    return escape(printable(str(value)))


def lines(value: str) -> str:
    """The same, keeping line ends."""
    return "\n".join(map(text, value.splitlines()))


def code(value: str) -> str:
    """The same for a line of code, keeping tabs."""
    return "\t".join(map(text, value.split("\t")))


def icon(severity: str) -> str:
    return f'<svg class="icon {severity}" aria-hidden="true"><use href="#icon-{severity}"/></svg>'


def embedded(data: Any) -> str:
    """JSON that can be in a script element: no character of it can end the element or a line."""
    written = json.dumps(data, separators=(",", ":"), sort_keys=True)
    return harmless(written).replace("&", "\\u0026").replace("<", "\\u003c").replace(">", "\\u003e")


def hashed(content: str) -> str:
    """The source expression of a content security policy that allows exactly this style or script."""
    return f"'sha256-{b64encode(sha256(content.encode('utf-8')).digest()).decode()}'"
