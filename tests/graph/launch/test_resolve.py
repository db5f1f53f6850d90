"""Values that a scope decides, and those that it does not."""

from __future__ import annotations

from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.source import Located
from bringup_lint.source import Source

PLACE = Source("a.launch.xml", "text").span(0, 4)


def text(value: str) -> Literal:
    return Literal(Located(value, PLACE), PLACE)


def test_a_text_that_no_scope_changes_is_not_made_anew() -> None:
    path = Concat((FileDir(PLACE), text("/next.launch.xml")), PLACE)
    assert Resolver(Scope({})).value(path) is path


def test_a_text_with_an_argument_is() -> None:
    rate = Argument(Located("rate", PLACE), text("10"), PLACE)
    resolved = Resolver(Scope({})).value(Concat((FileDir(PLACE), rate), PLACE))
    assert isinstance(resolved, Concat)
    assert [str(part.value) for part in resolved.parts if isinstance(part, Literal)] == ["10"]


def test_known_texts_become_one() -> None:
    resolved = Resolver(Scope({})).value(Concat((text("a"), text("b")), PLACE))
    assert isinstance(resolved, Literal)
    assert resolved.value == "ab"
