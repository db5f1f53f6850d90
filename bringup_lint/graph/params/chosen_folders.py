"""Folders out of which an argument of a launch file chooses a parameter file by its name."""

from __future__ import annotations

import os
from collections.abc import Iterator

from bringup_lint.graph.launch.launch import Launch
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import walk


def chosen_folders(launch: Launch) -> Iterator[str]:
    for file in launch.judged:
        names = set(_default_names(launch, file))
        if not names:
            continue
        for each in launch.references(file):
            path = each.found.file
            if path is not None and any(
                (value.span.source.name, value.span.start) in names for value in walk(each.value)
            ):
                yield os.path.dirname(os.path.abspath(path))


def _default_names(launch: Launch, file: LaunchFile) -> Iterator[tuple[str, int]]:
    """The places of texts that are the default of an argument, and the bare name of a YAML file."""
    for declared in launch.expansion(file).declared:
        default = declared.action.default
        text = literal_text(default)
        if default is not None and text is not None and "/" not in text and text.endswith((".yaml", ".yml")):
            yield default.span.source.name, default.span.start
