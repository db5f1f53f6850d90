"""What readers of tables say about a file, and how rules turn it into findings."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from collections.abc import Sequence
from typing import TYPE_CHECKING

from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.finding import Finding
from bringup_lint.on_demand import on_demand
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.model.schema import Code
    from bringup_lint.model.schema import Item
    from bringup_lint.model.schema import Remark
    from bringup_lint.schema.names import suggestions
else:
    __getattr__ = on_demand(globals())

__all__ = ["Code", "Item", "Remark", "explained", "suggestions", "unknown_name", "wrong_value"]


def explained(problems: Iterable[Problem], texts: Mapping[str, tuple[str, str]]) -> Iterator[Finding]:
    """One finding for each problem whose code has a message and an advice; ``{where}`` and ``{detail}`` in them are the
    problem's; where it is about more than a text, the first line of that."""
    for problem in problems:
        if problem.code in texts:
            where = problem.where if isinstance(problem.where, Located) else problem.where.text.partition("\n")[0]
            said = {"where": where, "detail": problem.detail}
            message, advice = (text.format(**said) for text in texts[problem.code])
            yield finding(problem.where, message, advice=advice)


def unknown_name(
    where: Located | Span,
    message: str,
    near: Sequence[str],
    otherwise: str,
    *,
    safe: bool = True,
    is_free: bool = True,
) -> Finding:
    """A name that the program does not know: renamed where one known name is near, which nothing beside it has."""
    return finding(
        where,
        message,
        advice=f"did you mean {' or '.join(near)}?" if near else otherwise,
        fix=fix(f"rename to {near[0]}", (where, near[0]), safe=safe) if len(near) == 1 and is_free else None,
    )


def wrong_value(
    where: Located | Span,
    message: str,
    right: str | None,
    otherwise: str,
    *,
    safe: bool = True,
    severity: str | None = None,
) -> Finding:
    """A value that the program does not take: replaced where it is known which one was meant."""
    return finding(
        where,
        message,
        advice=f"write {right}" if right else otherwise,
        fix=fix(f"write {right}", (where, right), safe=safe) if right else None,
        severity=severity,
    )
