"""Dataclasses whose methods are made with their first object. The modules of a run hold some hundred classes, of which
most get no object in a small tree, and Python writes and compiles the methods of each when it is defined."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:
    from _thread import RLock
    from collections.abc import Callable
    from typing import Any

    _OWN = frozenset({"__dict__", "__weakref__", "__slots__", "__doc__", "__module__"})
    """What each class has of its own."""
    _unfinished: dict[type, Callable[[], None]] = {}
    _lock = RLock()

    def dataclass(cls: type | None = None, /, **options: Any) -> Any:
        """As ``dataclasses.dataclass``, for classes without an ``__init__`` of their own."""
        if cls is None:
            return lambda cls: dataclass(cls, **options)
        plain = vars(cls).copy()
        if options.get("slots"):
            cls = _copy(cls, {**_without(plain, cls.__annotations__), "__slots__": tuple(cls.__annotations__)})

        def first(self: Any, *arguments: Any, **named: Any) -> None:
            finish(cls)
            cls.__init__(self, *arguments, **named)

        cls.__init__ = first
        _unfinished[cls] = lambda: _finish(cls, plain, options)
        return cls

    def finish(cls: type) -> None:
        """Make the methods of a class and of those that it extends."""
        with _lock:
            for each in reversed(cls.__mro__):
                if each in _unfinished:
                    _unfinished[each]()
                    del _unfinished[each]

    def _finish(cls: type, plain: dict[str, Any], options: dict[str, Any]) -> None:
        """Let Python make the methods in a copy of the class, and take them over, ``__init__`` last: another thread
        may be about to make an object."""
        from dataclasses import dataclass as complete

        made = dict(vars(complete(**options)(_copy(cls, plain))))
        kept = {*_OWN, *(cls.__annotations__ if options.get("slots") else ())}
        for name, value in made.items():
            if name not in kept and name != "__init__" and plain.get(name, made) is not value:
                setattr(cls, name, value)
        for name in cls.__annotations__.keys() & plain.keys() - made.keys() - kept:
            delattr(cls, name)
        cls.__init__ = made["__init__"]

    def _copy(cls: type, content: dict[str, Any]) -> type:
        return type(cls)(cls.__name__, cls.__bases__, _without(content, ("__dict__", "__weakref__")))

    def _without(content: dict[str, Any], names: Any) -> dict[str, Any]:
        return {name: value for name, value in content.items() if name not in names}
