"""Python expressions of launch files that end with an exception for a value which the choices of an argument allow."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.python_expression import failure
from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.scope import Binding
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import literal
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch

_WORDS = ("true", "false")
"""What IfCondition takes, and Python does not know."""


class Allowed(NamedTuple):
    expression: Operation
    name: str
    """The argument."""
    word: Located
    """The choice."""
    text: str
    """What launch evaluates."""
    error: str


def allowed_words(launch: Launch, file: LaunchFile) -> Iterator[Allowed]:
    """Each expression once that Python can evaluate with the defaults, and not with a word among the choices."""
    words = dict(_words(launch, file))
    expressions = _expressions(launch, file) if words else {}
    bindings = {name: _by_default(each) for name, each in launch.expansion(file).arguments.items()} if words else {}
    for expression in expressions.values():
        names = {str(each.name) for each in walk(expression) if isinstance(each, Argument)}
        if names.isdisjoint(words) or _failure(expression, bindings) is not None:
            continue
        for name in sorted(names & words.keys()):
            word = words[name]
            value = Literal(word, word.span)
            failed = _failure(expression, {**bindings, name: Binding(value, value, word.span, False)})
            if failed is not None and f"'{word}'" in failed[1]:
                yield Allowed(expression, name, word, *failed)
                break


def _words(launch: Launch, file: LaunchFile) -> Iterator[tuple[str, Located]]:
    """The arguments that a file declares with such a word among their choices."""
    for declared in launch.expansion(file).declared:
        action = declared.action
        if declared.file is file:
            choices = (literal(choice) for choice in action.choices or ())
            known = [choice for choice in choices if choice is not None and choice in _WORDS]
            default = literal(action.default) if action.default is not None else None
            other = [choice for choice in known if default is None or choice != default.lower()]
            yield from ((declared.name, choice) for choice in (other or known)[:1])


def _by_default(binding: Binding) -> Binding:
    """An argument whose default is an environment variable, as it is where nothing sets that."""
    value = binding.value
    return binding._replace(value=value.default) if isinstance(value, Env) and value.default is not None else binding


def _expressions(launch: Launch, file: LaunchFile) -> dict[int, Operation]:
    """By their place: the code of a loop makes one several times."""
    conditions = (part for condition in launch.conditions(file) for part in walk(condition.predicate))
    found = (each for each in (*file.expressions, *conditions) if isinstance(each, Operation) and each.name == "python")
    return {each.span.start: each for each in found}


def _failure(expression: Operation, bindings: dict[str, Binding]) -> tuple[str, str] | None:
    """The text of an expression, and what Python says of it."""
    text = text_of(Resolver(Scope(bindings)).value(expression.operands[0]))
    error = failure(text) if text is not None else None
    return (text, error) if text is not None and error is not None else None
