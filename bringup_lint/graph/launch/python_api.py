"""The Python interface of launch in the distribution that a file is for."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros import distros
from bringup_lint.facts.ros import launch_api
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.model.launch import LaunchFile
    from bringup_lint.model.launch import OldKeyword
    from bringup_lint.model.launch import RefusedCall

_LOOKS_AT_DISTRIBUTION = regex(r"ros_?distro|except TypeError", re.I, "ros_distro rosdistro typeerror")


def names_of(launch: Launch, module: str) -> frozenset[str] | None:
    """The public names of a module of launch or launch_ros; None when the module is not one of theirs."""
    return launch_api.names(module, launch.files.target.ros)


def looks_at_distribution(file: LaunchFile) -> bool:
    """Whether a file asks itself which distribution runs, or catches what another one raises."""
    return file.source.matches(_LOOKS_AT_DISTRIBUTION)


def distribution_of(launch: Launch, file: LaunchFile) -> str | None:
    """The distribution that a file is for, by its name, else that of the robot; None when it is not known."""
    return distros.named_in(file.source.basename) or launch.files.target.ros


def refused_calls(launch: Launch, file: LaunchFile) -> list[RefusedCall]:
    """The calls in a Python file that end with an exception; none when the file may catch it."""
    if looks_at_distribution(file):
        return []
    is_foxy = launch.files.target.ros == "foxy"
    return [each for each in file.calls_refused if not (is_foxy and each.code == "missing")]


def removed_keywords(launch: Launch, file: LaunchFile) -> Iterator[OldKeyword]:
    """The keywords in a Python file that its distribution no longer has; none when the file looks itself which
    distribution runs."""
    if looks_at_distribution(file):
        return
    for keyword in file.keywords:
        if keyword.name in launch_api.removed(keyword.owner, distribution_of(launch, file)):
            yield keyword
