"""Substitution objects that code takes for the text that they give only when launch performs them."""

from __future__ import annotations

from typing import Any

from bringup_lint.model.launch import ObjectAsValue
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import is_value
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.pattern import regex
from bringup_lint.source import Span

_CLASS = regex(r"(?:launch(?:_ros)?\.substitutions\.)?(?:Python|Path|FindPackage|Command|Environment|IfElse)\w*\(")
"""A call of a class of substitutions."""


def is_object(thing: Any) -> bool:
    """A ``LaunchConfiguration``, which equals no text and is none."""
    return isinstance(thing, Argument) and not thing.performed


def is_substitution(thing: Any) -> bool:
    """A substitution of any class that stands where it was made, in a file that performs none itself."""
    if is_object(thing):
        return True
    if not is_value(thing) or isinstance(thing, (Argument, Literal, Unknown)):
        return False
    return _CLASS.match(thing.span.text) is not None and "perform" not in thing.span.source.text


def is_text(thing: Any) -> bool:
    """A ``LaunchConfiguration`` that has been performed."""
    return isinstance(thing, Argument) and thing.performed


def note_object(state: State, how: str, thing: Any, span: Span) -> None:
    """Keep the place where an object is taken for its text, once however often the code runs."""
    if is_object(thing) and all(other.span.start != span.start for other in state.file.objects):
        state.file.objects.append(ObjectAsValue(how, span, thing))


def forget_printed(state: State, span: Span) -> None:
    """What is only printed changes nothing."""
    state.file.objects = [other for other in state.file.objects if not span.start <= other.span.start < span.end]
