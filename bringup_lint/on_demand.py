"""Modules that offer what others define, and import it when it is first asked for: a rule then loads what it names, and
not all that its subject has."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module

from bringup_lint.type_names import Any


def on_demand(module: dict[str, Any]) -> Callable[[str], Any]:
    """The ``__getattr__`` of a module, given its globals: it knows the names that the module imports for type checkers,
    one a line."""
    places: dict[str, str] = {}

    def attribute(name: str) -> Any:
        if not places:
            places.update(_imports(module["__file__"]))
        if name not in places:
            raise AttributeError(f"module {module['__name__']!r} has no attribute {name!r}")
        found = import_module(places[name])
        value = getattr(found, name) if hasattr(found, name) else import_module(f"{places[name]}.{name}")
        module[name] = value
        return value

    return attribute


def _imports(path: str) -> dict[str, str]:
    """Name -> module."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split() for line in file if line.startswith("    from ")]
    return {words[3]: words[1] for words in lines if len(words) == 4 and words[2] == "import"}
