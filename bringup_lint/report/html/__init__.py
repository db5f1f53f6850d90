"""The report for a person: one page that needs nothing else, with the findings and the picture of the bring-up."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import resources
from string import Template
from typing import TYPE_CHECKING
from typing import Any

from bringup_lint.report.html.document import document
from bringup_lint.report.html.findings import articles
from bringup_lint.report.html.heading import heading
from bringup_lint.report.html.heading import title_of
from bringup_lint.report.html.markup import embedded
from bringup_lint.report.html.markup import hashed
from bringup_lint.report.html.outline import outline
from bringup_lint.report.unicode import sound

if TYPE_CHECKING:
    from bringup_lint.report.model import Report

__all__ = ["page", "render"]

STYLES = ("shared.css", "style.css")
SCRIPTS = ("layout.js", "picture.js", "details.js", "camera.js", "search.js", "script.js")
"""One script in parts; only functions of one part are named in another before it runs."""


def render(report: Report) -> str:
    return page(report.picture or {}, report)


def page(picture: Mapping[str, Any], report: Report | None = None) -> str:
    """The page: the picture alone, or the findings of a report beside it.

    ``picture`` is what ``report.picture`` makes: layers, nodes, edges and the findings on them. The page loads
    nothing, and its content security policy names the hashes of the one style and the one script it holds.
    """
    data = document(picture, report)
    style = "".join(map(part, STYLES))
    script = "".join(map(part, SCRIPTS))
    filled = Template(part("page.html")).substitute(
        policy=f"default-src 'none'; img-src data:; style-src {hashed(style)}; script-src {hashed(script)}; "
        "base-uri 'none'; form-action 'none'",
        title=title_of(report),
        contents="report" if report else "picture",
        icons=part("icons.svg"),
        heading=heading(data, report),
        findings=articles(report) if report else "",
        outline=outline(data),
        style=style,
        data=embedded(data),
        script=script,
    )
    return str(sound(filled))


def part(name: str) -> str:
    """The text of a file that the page is made of."""
    return resources.files(__name__).joinpath(name).read_text("utf-8")
