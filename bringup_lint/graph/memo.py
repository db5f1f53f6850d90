"""What a layer works out once for each thing that it is asked about."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps

from bringup_lint.type_names import Any
from bringup_lint.type_names import TypeVar

Layer = TypeVar("Layer")
Thing = TypeVar("Thing")
Answer = TypeVar("Answer")


def memo(method: Callable[[Layer, Thing], Answer]) -> Callable[[Layer, Thing], Answer]:
    """Keep the answers of a method with one argument in the layer itself, by the argument. Units, sources and the
    like compare by identity, so that they are keys as they are."""
    name = f"_{method.__name__}_by_thing"

    @wraps(method)
    def answer(layer: Layer, thing: Thing) -> Answer:
        known: dict[Any, Answer] | None = layer.__dict__.get(name)
        if known is None:
            known = layer.__dict__[name] = {}
        if thing not in known:
            known[thing] = method(layer, thing)
        return known[thing]

    return answer
