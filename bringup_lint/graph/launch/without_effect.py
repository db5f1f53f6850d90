"""Values of arguments that ask for what happens without them, so that nothing is lost where nobody takes them."""

from __future__ import annotations

from collections.abc import Collection
from collections.abc import Iterable
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.model.launch_values import literal

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.model.launch_values import Value

CLOCK = "use_sim_time"
_OFF = ("false", "0")
_SWITCH = "use_"


def is_real_clock(name: str, text: str | None) -> bool:
    """Whether an argument asks for the clock that every node has when nothing gives it another."""
    return name == CLOCK and (text or "").lower() in _OFF


def is_empty(text: str | None) -> bool:
    """Whether the shell, xacro or launch gets no text at all, as with ``prefix:=""``."""
    return text is not None and not text.strip(" \"'")


def passed_without_effect(arguments: Iterable[tuple[Value, Value]], target: Expansion) -> Collection[str]:
    """The names of the literal arguments of an include that change nothing, whether the target takes them or not: an
    empty text, the real clock where nothing of the target speaks of it, and ``use_X`` off beside an empty ``X``."""
    texts = {str(literal(name)): text_of(value) for name, value in arguments}
    speaks = any(CLOCK in file.source.text for file in target.files)
    return [name for name, text in texts.items() if _changes_nothing(name, text, texts, speaks)]


def _changes_nothing(name: str, text: str | None, texts: dict[str, str | None], speaks_of_clock: bool) -> bool:
    if is_empty(text):
        return True
    if is_real_clock(name, text):
        return not speaks_of_clock
    return name.startswith(_SWITCH) and (text or "").lower() in _OFF and is_empty(texts.get(name[len(_SWITCH) :]))
