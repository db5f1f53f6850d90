"""The head of the page: what was looked at, and what came of it."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Mapping
from typing import TYPE_CHECKING
from typing import Any

from bringup_lint.plural import counted
from bringup_lint.report.html.markup import text
from bringup_lint.report.paint import painter
from bringup_lint.report.summary import summary

if TYPE_CHECKING:
    from bringup_lint.report.model import Report


def title_of(report: Report | None) -> str:
    name = report.root.rstrip("/").rpartition("/")[2] if report else ""
    return f"{text(name)} · bringup-lint" if name else "Bring-up · bringup-lint"


def heading(data: Mapping[str, Any], report: Report | None) -> str:
    """The name of the tree, the summary line, and in small print what the run assumed."""
    name = report.root.rstrip("/").rpartition("/")[2] if report else ""
    head, asides = _summary(data, report)
    small = [*asides, *(_assumed(report) if report else ())]
    return (
        f"<h1>{text(name or 'Bring-up')}</h1>"
        f'<p class="summary">{text(head)}</p>'
        + (f'<p class="small">{" · ".join(map(text, small))}</p>' if small else "")
        + "".join(_notices(report) if report else ())
    )


def _summary(data: Mapping[str, Any], report: Report | None) -> tuple[str, list[str]]:
    if report:
        head, *asides = summary(report, 1, painter(False)).splitlines()
        return head, asides
    if not data["nodes"]:
        return "", []
    counts = (len(data[part]) for part in ("nodes", "edges", "layers"))
    return ", ".join(map(counted, counts, ("node", "edge", "layer"))), []


def _assumed(report: Report) -> Iterator[str]:
    target = report.target
    if target.ros:
        yield f"ROS 2 {target.ros.capitalize()}" + (f" ({target.ros_why})" if target.ros_why else "")
    if target.systemd:
        yield f"systemd {target.systemd}" + (f" ({target.systemd_why})" if target.systemd_why else "")
    if report.started is not None:
        from datetime import datetime
        from datetime import timezone

        yield datetime.fromtimestamp(report.started, timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    yield f"bringup-lint {report.version}"


def _notices(report: Report) -> Iterator[str]:
    for told in report.notifications:
        yield f'<p class="notice {text(told.level)}">{text(told.message)}</p>'
