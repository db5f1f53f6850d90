"""Dataclasses whose methods are made with their first object. The modules of a run hold some hundred classes, of which
most get no object in a small tree, and few get many: Python writes and compiles the methods of each when it is defined.
Here only ``__init__`` is compiled, once there are some objects: ``dataclasses`` is not imported, which would load the
modules that take Python code apart."""

from __future__ import annotations

from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
    from dataclasses import field as field
    from dataclasses import replace as replace
else:
    from _thread import RLock
    from collections.abc import Callable
    from operator import attrgetter
    from reprlib import recursive_repr

    from bringup_lint.type_names import Any

    _NOTHING = object()
    """The default of a field that has none."""
    _FEW = 16
    """Objects that are made before ``__init__`` is compiled, which takes as long as to make so many without."""
    _unfinished: dict[type, Callable[[], None]] = {}
    _lock = RLock()

    class Field:
        """What a class says of one of its values."""

        __slots__ = ("default", "default_factory", "init", "kw_only")

        def __init__(self, default: Any, default_factory: Any, init: bool, kw_only: bool = False) -> None:
            self.default = default
            self.default_factory = default_factory
            self.init = init
            self.kw_only = kw_only

    def field(*, default: Any = _NOTHING, default_factory: Any = _NOTHING, init: bool = True) -> Any:
        """As ``dataclasses.field``."""
        return Field(default, default_factory, init)

    def replace(value: Any, /, **changes: Any) -> Any:
        """As ``dataclasses.replace``."""
        for name, each in type(value).__fields__.items():
            if each.init and name not in changes:
                changes[name] = getattr(value, name)
        return type(value)(**changes)

    def dataclass(cls: type | None = None, /, **options: bool) -> Any:
        """As ``dataclasses.dataclass``, for classes without an ``__init__`` of their own."""
        if cls is None:
            return lambda cls: dataclass(cls, **options)
        own = _own_fields(cls, options.get("kw_only", False))
        if options.get("slots"):
            cls = _with_slots(cls, own)
        else:
            _set_defaults(cls, own)
        inherited = (getattr(base, "__fields__", {}) for base in reversed(cls.__bases__))
        cls.__fields__ = {name: each for fields in (*inherited, own) for name, each in fields.items()}
        cls.__match_args__ = tuple(name for name, each in cls.__fields__.items() if each.init and not each.kw_only)
        cls.__dataclass_fields__ = _ForPython()

        def first(self: Any, *arguments: Any, **named: Any) -> None:
            finish(cls)
            cls.__init__(self, *arguments, **named)

        cls.__init__ = first
        _unfinished[cls] = lambda: _finish(cls, options)
        return cls

    def finish(cls: type) -> None:
        """Make the methods of a class and of those that it extends."""
        with _lock:
            for each in reversed(cls.__mro__):
                if each in _unfinished:
                    _unfinished[each]()
                    del _unfinished[each]

    def _own_fields(cls: type, kw_only: bool) -> dict[str, Field]:
        fields = {}
        for name in cls.__annotations__:
            given = vars(cls).get(name, _NOTHING)
            fields[name] = given if isinstance(given, Field) else Field(given, _NOTHING, True)
            fields[name].kw_only = kw_only
        return fields

    def _set_defaults(cls: type, fields: dict[str, Field]) -> None:
        for name, each in fields.items():
            if isinstance(vars(cls).get(name), Field):
                if each.default is _NOTHING:
                    delattr(cls, name)
                else:
                    setattr(cls, name, each.default)

    def _with_slots(cls: type, fields: dict[str, Field]) -> type:
        """The class once more: slots cannot be added to one that is made already."""
        left_out = {"__dict__", "__weakref__", *fields}
        content = {name: value for name, value in vars(cls).items() if name not in left_out}
        return type(cls)(cls.__name__, cls.__bases__, {**content, "__slots__": tuple(fields)})

    def _finish(cls: type, options: dict[str, bool]) -> None:
        """Make the methods, ``__init__`` last: another thread may be about to make an object."""
        methods: dict[str, Any] = {"__repr__": _repr}
        if options.get("eq", True):
            methods |= _comparing(cls, frozen=options.get("frozen", False))
        if options.get("frozen"):
            methods |= _freezing(cls)
        for name, method in methods.items():
            if vars(cls).get(name) is None:
                setattr(cls, name, method)
        cls.__init__ = _init_of_few(cls, frozen=options.get("frozen", False))

    @recursive_repr()
    def _repr(self: Any) -> str:
        values = (f"{name}={getattr(self, name)!r}" for name in type(self).__fields__)
        return f"{type(self).__qualname__}({', '.join(values)})"

    def _comparing(cls: type, *, frozen: bool) -> dict[str, Any]:
        """Objects are equal when all values are; only those that never change have a hash."""
        names = tuple(cls.__fields__)
        values = attrgetter(*names) if names else lambda _: ()

        def __eq__(self: Any, other: object) -> Any:
            return values(self) == values(other) if other.__class__ is self.__class__ else NotImplemented

        def __hash__(self: Any) -> int:
            return hash(values(self))

        return {"__eq__": __eq__, "__hash__": __hash__ if frozen else None}

    def _freezing(cls: type) -> dict[str, Any]:
        names = frozenset(cls.__fields__)

        def __setattr__(self: Any, name: str, value: object) -> None:
            if type(self) is cls or name in names:
                raise _frozen("assign to", name)
            super(cls, self).__setattr__(name, value)

        def __delattr__(self: Any, name: str) -> None:
            if type(self) is cls or name in names:
                raise _frozen("delete", name)
            super(cls, self).__delattr__(name)

        return {"__setattr__": __setattr__, "__delattr__": __delattr__}

    def _frozen(what: str, name: str) -> Exception:
        from dataclasses import FrozenInstanceError

        return FrozenInstanceError(f"cannot {what} field {name!r}")

    def _init_of_few(cls: type, *, frozen: bool) -> Any:
        """The method that takes the values of the first objects. It gives way to the compiled one after these, and
        where the values do not fit, of which the compiled one complains."""
        fields = cls.__fields__
        positional = cls.__match_args__
        taken = {name for name, each in fields.items() if each.init}
        needed = {name for name in taken if fields[name].default is fields[name].default_factory is _NOTHING}
        put = object.__setattr__ if frozen else setattr
        has_more = hasattr(cls, "__post_init__")
        left = _FEW

        def __init__(self: Any, *values: Any, **named: Any) -> None:
            nonlocal left
            left -= 1
            given = {**dict(zip(positional, values)), **named}
            if left < 0 or len(given) < len(values) + len(named) or not needed <= given.keys() <= taken:
                cls.__init__ = _init(cls, frozen=frozen)
                cls.__init__(self, *values, **named)
                return
            for name, each in fields.items():
                if name in given:
                    put(self, name, given[name])
                else:
                    put(self, name, each.default if each.default_factory is _NOTHING else each.default_factory())
            if has_more:
                self.__post_init__()

        return __init__

    def _init(cls: type, *, frozen: bool) -> Any:
        """The method that takes the values, written and compiled, as it is called most of all."""
        known: dict[str, Any] = {"_set": object.__setattr__, "_NOTHING": _NOTHING}
        body = []
        for name, each in cls.__fields__.items():
            known[f"_default_{name}"], known[f"_make_{name}"] = each.default, each.default_factory
            value = name if each.init else f"_default_{name}"
            if each.default_factory is not _NOTHING:
                value = f"_make_{name}() if {name} is _NOTHING else {name}" if each.init else f"_make_{name}()"
            body.append(f"_set(self, {name!r}, {value})" if frozen else f"self.{name} = {value}")
        if hasattr(cls, "__post_init__"):
            body.append("self.__post_init__()")
        lines = "\n ".join(body or ["pass"])
        exec(f"def __init__({', '.join(_parameters(cls.__fields__))}):\n {lines}", known)  # names of the class alone
        known["__init__"].__qualname__ = f"{cls.__qualname__}.__init__"
        return known["__init__"]

    def _parameters(fields: dict[str, Field]) -> list[str]:
        taken = {name: each for name, each in fields.items() if each.init}
        named = [_parameter(name, each) for name, each in taken.items() if each.kw_only]
        return [
            "self",
            *(_parameter(name, each) for name, each in taken.items() if not each.kw_only),
            *(["*", *named] if named else []),
        ]

    def _parameter(name: str, each: Field) -> str:
        if each.default_factory is not _NOTHING:
            return f"{name}=_NOTHING"
        return name if each.default is _NOTHING else f"{name}=_default_{name}"

    class _ForPython:
        """What the functions of ``dataclasses`` ask for, made when they ask."""

        def __get__(self, value: object, cls: type) -> dict[str, Any]:
            import dataclasses

            def made(each: Field) -> Any:
                given = {"default": each.default, "default_factory": each.default_factory}
                known = {name: what for name, what in given.items() if what is not _NOTHING}
                return dataclasses.field(**known, init=each.init, kw_only=each.kw_only)

            fields = [(name, object, made(each)) for name, each in cls.__fields__.items()]
            return dataclasses.make_dataclass(cls.__name__, fields).__dataclass_fields__
