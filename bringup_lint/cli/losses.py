"""What the settings that ``init`` proposes would take away: findings in the folders that they leave out or give a
purpose."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.cli.reading import read_robot
from bringup_lint.cli.run_options import RunOptions
from bringup_lint.config import Config
from bringup_lint.engine import run
from bringup_lint.finding import Severity
from bringup_lint.registry import Registry

if TYPE_CHECKING:
    from bringup_lint.cli.survey import Setting
    from bringup_lint.finding import Finding
    from bringup_lint.robot import Robot


def with_losses(settings: list[Setting], robot: Robot) -> list[Setting]:
    """The settings, each with the number of errors and warnings that are found without it alone."""
    if not any(each.folder for each in settings):
        return settings
    exclude = tuple(each.value for each in settings if each.table == "exclude")
    purpose = {each.name: each.value for each in settings if each.table == "purpose"}
    left = Counter(map(_key, _found(read_robot((".",), Config(exclude=exclude, purpose=purpose), RunOptions()))))
    lost = list(_lost(_found(robot), left))
    return [_counted(each, lost) for each in settings]


def _found(robot: Robot) -> Iterator[Finding]:
    outcome = run(robot, Registry.of(()), Config())
    return (found for found in outcome.findings if found.suppression is None)


def _lost(found: Iterable[Finding], left: Counter[tuple[object, ...]]) -> Iterator[Finding]:
    for each in found:
        if left[_key(each)]:
            left[_key(each)] -= 1
        else:
            yield each


def _key(found: Finding) -> tuple[object, ...]:
    return found.rule, found.source.name, found.span.start, found.severity


def _counted(setting: Setting, lost: Iterable[Finding]) -> Setting:
    if not setting.folder:
        return setting
    counts = Counter(each.severity for each in lost if each.source.name.startswith(setting.folder))
    return setting._replace(errors=counts[Severity.ERROR], warnings=counts[Severity.WARNING])
