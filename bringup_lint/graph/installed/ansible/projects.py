"""Which files belong to one project of Ansible: a tree may hold several, each with its own settings and roles."""

from __future__ import annotations

import os

from bringup_lint.pattern import regex

_INNER = regex(r"/(?:roles|playbooks|plays|tasks|handlers)/")
_OF_COMMANDS = regex(r"/(?:scripts?|tools?|bin|ci|\.github(?:/workflows)?)$")
"""Folders of what calls Ansible for the folder above."""


def project_of(path: str) -> str:
    """The folder of the project that a playbook or a file of a role belongs to."""
    absolute = os.path.abspath(path)
    inner = _INNER.search(absolute)
    return absolute[: inner.start()] if inner is not None else os.path.dirname(absolute)


def concerns(path: str, project: str) -> bool:
    """Whether a file may say something of a project: it lies in it, or in a folder above."""
    folder = _OF_COMMANDS.sub("", os.path.dirname(os.path.abspath(path)))
    return f"{folder}/".startswith(f"{project}/") or f"{project}/".startswith(f"{folder}/")
