"""What the files say about domain and middleware."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.ros_values import MAX_DOMAIN
from bringup_lint.parsers.ros_values import RMW_IMPLEMENTATIONS
from bringup_lint.parsers.ros_values import domain_id
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.commands.environment import Environment
    from bringup_lint.graph.environment.ros import RosEnvironment


class Domain(NamedTuple):
    number: int
    where: Located


def of_environment(environment: Environment | None) -> Domain | None:
    """The domain of a process, where its environment sets one that is known."""
    variable = environment.get("ROS_DOMAIN_ID") if environment else None
    return _domain(variable.value, variable.text) if variable else None


def configured(ros: RosEnvironment) -> Domain | None:
    """The one domain of all processes that set one; without processes, of all files that set one."""
    found = [domain for process in ros.processes if (domain := of_environment(process.environment))]
    if not found:
        settings = [each for each in ros.of("ROS_DOMAIN_ID") if not ros.is_development(each.value)]
        found = [domain for each in settings if (domain := _domain(each.value, each.text))]
    return found[0] if len({domain.number for domain in found}) == 1 else None


def mentioned(ros: RosEnvironment) -> list[int]:
    """Every domain that a file sets, and the default, ascending."""
    found = (_domain(each.value, each.text) for each in ros.of("ROS_DOMAIN_ID"))
    return sorted({0, *(domain.number for domain in found if domain)})


def _domain(value: Located, text: str | None) -> Domain | None:
    number = domain_id(text).number if text is not None else None
    return Domain(number, value) if number is not None and number <= MAX_DOMAIN else None


def middleware(ros: RosEnvironment) -> Located | None:
    """The middleware that all files agree on, when it is one that is known."""
    values = {each.text: each.value for each in ros.of("RMW_IMPLEMENTATION") if not ros.is_development(each.value)}
    return next(iter(values.values())) if len(values) == 1 and next(iter(values)) in RMW_IMPLEMENTATIONS else None
