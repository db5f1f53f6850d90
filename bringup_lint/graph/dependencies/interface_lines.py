"""Definitions of messages, services and actions from which rosidl makes no code."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING

from bringup_lint.facts import rows
from bringup_lint.graph.dependencies.interfaces import is_judged
from bringup_lint.graph.dependencies.interfaces import is_place
from bringup_lint.graph.interface_files import KINDS
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers import interface_grammar
from bringup_lint.parsers.interface_grammar import PRIMITIVE
from bringup_lint.pattern import regex
from bringup_lint.source import Problem
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.dependencies.interfaces import PackageInterfaces
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.workspace import Package
    from bringup_lint.graph.workspace import Workspace
    from bringup_lint.parsers.interface_grammar import FieldType
    from bringup_lint.source import Source


_FILE = regex(r"(?P<kind>msg|srv|action)/(?P<name>[\w-]+)\.(?P<ending>msg|srv|action)\Z")
_NAME = regex(r"[A-Z][A-Za-z0-9]*\Z")
"""The names of interfaces that rosidl takes."""


class RefusedDefinition(NamedTuple):
    """A definition that the build of its package generates and rosidl refuses."""

    package: Package
    source: Source
    problems: list[Problem]
    """In order; ``unknown`` is the type of a message that does not exist. The detail is what may be meant."""


def refused_definitions(
    files: Files, workspace: Workspace, interfaces_of: Callable[[Package], PackageInterfaces]
) -> Iterator[RefusedDefinition]:
    for package in workspace.packages.values():
        interfaces = interfaces_of(package)
        if package.complete and not package.manifest.for_both:
            yield from _misnamed(files, package, interfaces)
        if not is_judged(package, interfaces) or not interfaces.generators or package.manifest.for_both:
            continue
        for path in _generated(package, interfaces):
            source = files.tree.at(path)
            if source is None or not source.judged or source.template or files.is_test_data(source):
                continue
            lines = interface_grammar.parse(source)
            unknown = (_unknown(package, workspace, interfaces_of, each) for each in lines.types)
            problems = [*map(_meant, lines.problems), *filter(None, unknown)]
            if problems:
                problems.sort(key=lambda each: each.span.start)
                yield RefusedDefinition(package, source, problems)


def _misnamed(files: Files, package: Package, interfaces: PackageInterfaces) -> Iterator[RefusedDefinition]:
    """Files that the command lists, and whose name is none of an interface."""
    for word in interfaces.words or ():
        match = _FILE.match(word)
        path = os.path.join(package.folder, word)
        if match is None or _NAME.match(match["name"]) or not files.tree.exists(path) or not word.span.source.judged:
            continue
        meant = "".join(part[:1].upper() + part[1:] for part in match["name"].split("_"))
        problem = Problem("file-name", word, f"{match['kind']}/{meant}.{match['ending']}" if _NAME.match(meant) else "")
        yield RefusedDefinition(package, word.span.source, [problem])


def _generated(package: Package, interfaces: PackageInterfaces) -> Iterator[str]:
    """The files that lie where definitions do and that the command lists, or may list."""
    listed = interfaces.listed
    for (kind, name), path in interfaces.defined.items():
        is_text = kind in KINDS and not path.endswith(".idl")
        if is_text and is_place(package, kind, path) and (listed is None or name in listed):
            yield path


def _meant(problem: Problem) -> Problem:
    """With the primitive type that is nearly written so."""
    near = nearest(problem.span.text, sorted(PRIMITIVE)) if problem.code in ("type", "constant-type") else []
    return Problem(problem.code, problem.where, near[0]) if len(near) == 1 else problem


def _unknown(
    package: Package,
    workspace: Workspace,
    interfaces_of: Callable[[Package], PackageInterfaces],
    each: FieldType,
) -> Problem | None:
    """A message that no package has, as far as this is known."""
    owner = package if each.package in ("", package.name) else workspace.packages.get(each.package)
    known = _common().get(each.package, ())
    if owner is not None:
        interfaces = interfaces_of(owner)
        own = [name for kind, name in interfaces.defined if kind == "msg"]
        if each.message in own or not interfaces.is_closed or owner.manifest.is_ros1:
            return None
        near = nearest(each.message, own)
        if not each.package and not near:
            elsewhere = [f"{name}/{each.message}" for name, types in _common().items() if each.message in types]
            return Problem("unknown", each.name, elsewhere[0] if len(elsewhere) == 1 else "")
    elif not known or each.message in known or each.package in workspace.ambiguous:
        return None
    else:
        near = [name for name in nearest(each.message, known) if not numbered(name, each.message)]
        if len(near) != 1:
            return None
    prefix = f"{each.package}/" if each.package else ""
    return Problem("unknown", each.name, f"{prefix}{near[0]}" if len(near) == 1 else "")


@cache
def _common() -> dict[str, list[str]]:
    """Public package -> its messages."""
    found: dict[str, list[str]] = {}
    for name, _ in rows("ros/message_fields")[1]:
        package, kind, message = name.split("/")
        if kind == "msg":
            found.setdefault(package, []).append(message)
    return found
