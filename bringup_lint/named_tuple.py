"""Named tuples that are made quickly: ``typing`` compiles each annotation and the constructor of each class when it is
defined. Here the constructor is compiled once there are some objects, and no annotation is."""

from __future__ import annotations

from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import NamedTuple as NamedTuple
else:
    from collections import _tuplegetter

    from bringup_lint.type_names import Any

    _new = tuple.__new__
    _FEW = 16
    """Objects that are made before the constructor is compiled, which takes as long as to make so many without."""

    class _Kind(type):
        """Makes a class of tuples from the annotations in its body."""

        def __new__(mcs, name: str, bases: tuple[type, ...], body: dict[str, Any]) -> Any:
            if bases == (tuple,) or NamedTuple not in bases:
                return super().__new__(mcs, name, bases, body)
            fields = tuple(_annotations(body))
            defaults = {field: body[field] for field in fields if field in body}
            getters = {field: _tuplegetter(at, field) for at, field in enumerate(fields)}
            known = {"__slots__": (), "_fields": fields, "_field_defaults": defaults, "__match_args__": fields}
            made = super().__new__(mcs, name, bases, {**body, **known, **getters})
            made.__new__ = _of_few(made, fields, defaults)
            return made

    def _annotations(body: dict[str, Any]) -> Any:
        """By name. Python 3.14 has a function for them, where a module does not leave them as text."""
        if "__annotations__" in body:
            return body["__annotations__"]
        return body["__annotate_func__"](3) if "__annotate_func__" in body else {}

    def _of_few(made: type, fields: tuple[str, ...], defaults: dict[str, Any]) -> Any:
        """The constructor of the first objects. It gives way to the compiled one after these, and where the values do
        not fit, of which the compiled one complains."""
        names = set(fields)
        left = _FEW

        def __new__(cls: type, *values: Any, **named: Any) -> Any:
            nonlocal left
            left -= 1
            given = {**dict(zip(fields, values)), **named}
            is_clear = len(given) == len(values) + len(named)
            given = {**defaults, **given}
            if left < 0 or not is_clear or given.keys() != names:
                made.__new__ = _constructor(made.__name__, fields, defaults)
                return made.__new__(cls, *values, **named)
            return _new(cls, map(given.__getitem__, fields))

        return __new__

    def _constructor(name: str, fields: tuple[str, ...], defaults: dict[str, Any]) -> Any:
        """Written and compiled, as it is called most of all."""
        known = {"_new": _new, **{f"_default_{field}": value for field, value in defaults.items()}}
        taken = [f"{field}=_default_{field}" if field in defaults else field for field in fields]
        given = "".join(f"{field}, " for field in fields)
        constructor = eval(f"lambda {', '.join(['_cls', *taken])}: _new(_cls, ({given}))", known)  # names of the class
        constructor.__name__, constructor.__qualname__ = "__new__", f"{name}.__new__"
        return constructor

    class NamedTuple(tuple, metaclass=_Kind):
        """As ``typing.NamedTuple``."""

        __slots__ = ()
        _fields: tuple[str, ...]

        @classmethod
        def _make(cls, values: Any) -> Any:
            made = _new(cls, values)
            if len(made) != len(cls._fields):
                raise TypeError(f"expected {len(cls._fields)} arguments, got {len(made)}")
            return made

        def _replace(self, /, **changes: Any) -> Any:
            made = self._make(map(changes.pop, self._fields, self))
            if changes:
                raise ValueError(f"got unexpected field names: {list(changes)!r}")
            return made

        def _asdict(self) -> dict[str, Any]:
            return dict(zip(self._fields, self, strict=True))

        def __repr__(self) -> str:
            values = (f"{field}={value!r}" for field, value in zip(self._fields, self, strict=True))
            return f"{type(self).__name__}({', '.join(values)})"

        def __getnewargs__(self) -> tuple[Any, ...]:
            return tuple(self)
