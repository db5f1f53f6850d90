"""Names of parameters that libraries declare are compared, and only patterns are compiled."""

from __future__ import annotations

import fnmatch

import pytest

from bringup_lint.facts import table
from bringup_lint.facts.ros import parameters


def test_plain_names_are_not_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []
    match = fnmatch.fnmatchcase

    def counted(name: str, pattern: str) -> bool:
        asked.append(pattern)
        return match(name, pattern)

    monkeypatch.setattr(parameters, "fnmatchcase", counted)
    for node in parameters.public_nodes():
        node.declares("no_such_parameter")
        node.type_of("no_such_parameter")
    assert asked
    assert all(set("*?[") & set(pattern) for pattern in asked)


def test_names_are_compared_as_fnmatch_does() -> None:
    patterns = [name for row in table("ros/parameter_free") for name in row["names"].split()]
    every = (*parameters.OF_EVERY_NODE, *patterns)
    names = [pattern.replace("*", "any") for pattern in every]
    for name in (*names, "qos_overrides./tf.publisher.depth", "use_sim_times", ""):
        assert parameters.is_of_library(name) == any(fnmatch.fnmatchcase(name, pattern) for pattern in every)
