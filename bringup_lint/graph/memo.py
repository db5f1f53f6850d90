"""What a layer works out once, by itself or for each thing that it is asked about."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps

from bringup_lint.type_names import Any
from bringup_lint.type_names import TypeVar

Layer = TypeVar("Layer")
Thing = TypeVar("Thing")
Answer = TypeVar("Answer")


def memo(method: Callable[[Layer, Thing], Answer]) -> Callable[[Layer, Thing], Answer]:
    """Keep the answers of a method with one argument, or of a function of a layer and one thing, in the layer itself,
    by the thing. Units, sources and the like compare by identity, so that they are keys as they are."""
    name = f"_{method.__module__}.{method.__qualname__} by thing"

    @wraps(method)
    def answer(layer: Layer, thing: Thing) -> Answer:
        known: dict[Any, Answer] | None = layer.__dict__.get(name)
        if known is None:
            known = layer.__dict__[name] = {}
        if thing not in known:
            known[thing] = method(layer, thing)
        return known[thing]

    return answer


def kept(function: Callable[[Layer], Answer]) -> Callable[[Layer], Answer]:
    """Keep the answer of a function of a layer in the layer itself, as ``cached_property`` does for its own."""
    name = f"_{function.__module__}.{function.__qualname__}"

    @wraps(function)
    def answer(layer: Layer) -> Answer:
        if name not in layer.__dict__:
            layer.__dict__[name] = function(layer)
        found: Answer = layer.__dict__[name]
        return found

    return answer
