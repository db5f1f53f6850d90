"""Python's own functions, ``os``, ``pathlib`` and package lookups."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bringup_lint.model.launch import Call
from bringup_lint.model.launch_values import VALUE_TYPES
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.containers import extend
from bringup_lint.parsers.launch_python.containers import in_order
from bringup_lint.parsers.launch_python.containers import iterate
from bringup_lint.parsers.launch_python.containers import merge
from bringup_lint.parsers.launch_python.containers import put
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.operators import performed
from bringup_lint.parsers.launch_python.state import Builder
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.truth import truth
from bringup_lint.parsers.launch_python.unperformed import forget_printed
from bringup_lint.parsers.launch_python.unperformed import is_object
from bringup_lint.parsers.launch_python.unperformed import note_object
from bringup_lint.source import Located
from bringup_lint.source import Span

_OPENING = frozenset(("open", "os.path.expanduser", "xacro.process_file"))
"""Functions that take a path."""


def path(state: State, thing: Any) -> Value:
    """An argument that is a path: ``__file__`` becomes this launch file."""
    if isinstance(thing, Symbol) and thing.name == "__file__":
        return FileDir(thing.span, itself=True)
    return freeze.text(state, thing)


def join_path(state: State, parts: list[Value], span: Span) -> Value:
    flat: list[Value] = []
    for part in parts:
        flat.extend(part.parts if isinstance(part, PathJoin) else (part,))
    return flat[0] if len(flat) == 1 else budget.bounded(PathJoin(tuple(flat), span))


def parent(value: Value, span: Span) -> Value:
    """The folder of a path."""
    if isinstance(value, FileDir):
        return FileDir(span) if value.itself else PathJoin((value, Literal(Located("..", span), span)), span)
    if isinstance(value, PathJoin) and isinstance(value.parts[-1], Literal):
        name = str(value.parts[-1].value).rstrip("/")
        head = name.rpartition("/")[0]
        if name in ("..", ".", ""):
            return PathJoin((*value.parts, Literal(Located("..", span), span)), span)
        rest = value.parts[:-1]
        if head:
            return PathJoin((*rest, Literal(Located(head, span), span)), span)
        return rest[0] if len(rest) == 1 else PathJoin(rest, span)
    if isinstance(value, Literal) and isinstance(value.value, str):
        return Literal(Located(str(value.value).rstrip("/").rpartition("/")[0], span), span)
    return Unknown("folder of a path", span)


def _join(state: State, args: Arguments) -> Any:
    if args.more or not args.positional:
        return Unknown("path", args.span)
    objects = [thing for thing in args.positional if is_object(thing)]
    if objects:
        note_object(state, "path", objects[0], args.span)
        return Unknown("a substitution object in os.path.join", args.span)
    return _distributed(state, args.positional, args.span)


def _distributed(state: State, things: list[Any], span: Span) -> Any:
    """Paths with one component that is an ``Options`` become Options of paths."""
    for index, thing in enumerate(things):
        if isinstance(thing, Options) and len(thing.options) <= 8:
            state.tick(len(things) * 4)
            cases = [(own, [*things[:index], one, *things[index + 1 :]]) for own, one in thing.options]
            return Options([(own, _distributed(state, case, span)) for own, case in cases], span)
    return join_path(state, [path(state, thing) for thing in things], span)


def _path(state: State, args: Arguments) -> Any:
    if not args.positional:
        return Unknown("working folder", args.span)
    for thing in args.positional:
        note_object(state, "path", thing, args.span)
    return _distributed(state, args.positional, args.span)


def _dirname(state: State, args: Arguments) -> Any:
    return parent(path(state, args.need("p", 0)), args.span)


def _same_path(state: State, args: Arguments) -> Any:
    return path(state, args.need("path", 0))


def _basename(state: State, args: Arguments) -> Any:
    value = args.word("p", 0)
    return Unknown("file name", args.span) if value is None else Literal(value.rpartition("/")[2], args.span)


def _exists(state: State, args: Arguments) -> Any:
    thing = args.need("path", 0)
    note_object(state, "path", thing, args.span)
    return Operation("exists", (path(state, thing),), args.span)


def _share(state: State, args: Arguments) -> Any:
    return PackageShare(performed(state, args.need("package_name", 0), args.span), args.span)


def _prefix(state: State, args: Arguments) -> Any:
    return PackagePrefix(performed(state, args.need("package_name", 0), args.span), args.span)


def _getenv(state: State, args: Arguments) -> Any:
    name = args.get("key", 0)
    if not isinstance(name, Literal) or not isinstance(name.value, Located):
        return Unknown("environment", args.span)
    default = args.get("default", 1)
    return Env(name.value, Literal(None, args.span) if default is None else freeze.value(state, default), args.span)


def _noted(name: str, why: str) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        if name in _OPENING and args.positional:
            note_object(state, "path", args.positional[0], args.span)
        values = tuple(freeze.value(state, thing) for thing in args.positional)
        state.file.calls.append(Call(name, args.span, values, state.deferred > 0))
        return Unknown(why, args.span)

    return builder


def _str(state: State, args: Arguments) -> Any:
    return performed(state, args.need("object", 0), args.span)


def _number(kind: Callable[[Any], int | float]) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        value = args.get("x", 0)
        note_object(state, "number", value, args.span)
        if isinstance(value, Literal) and len(args.positional) == 1:
            try:
                return Literal(kind(value.value), args.span)
            except (TypeError, ValueError, OverflowError):
                return Unknown("number", args.span)
        if isinstance(value, Argument) and value.performed:
            return value
        return Unknown("number", args.span)

    return builder


def _bool(state: State, args: Arguments) -> Any:
    thing = args.need("x", 0)
    note_object(state, "condition", thing, args.span)
    outcome = truth(state, thing, args.span)
    return Literal(outcome, args.span) if isinstance(outcome, bool) else outcome


def _length(state: State, args: Arguments) -> Any:
    thing = args.get("obj", 0)
    if isinstance(thing, Sequence) and thing.plain() is not None:
        return Literal(len(thing.items), args.span)
    if isinstance(thing, Literal) and isinstance(thing.value, str):
        return Literal(len(thing.value), args.span)
    return Unknown("length", args.span)


def _range(state: State, args: Arguments) -> Any:
    bounds = [part.value for part in args.positional if isinstance(part, Literal) and type(part.value) is int]
    if len(bounds) != len(args.positional) or not bounds or (len(bounds) == 3 and bounds[2] == 0):
        return Unknown("range", args.span)
    numbers = range(*bounds[:3])
    if numbers[budget.ITEMS : budget.ITEMS + 1]:
        return Unknown("range", args.span)
    state.tick(len(numbers))
    return Sequence([((), Literal(number, args.span)) for number in numbers], args.span, state.guards)


def _enumerate(state: State, args: Arguments) -> Any:
    items = iterate(state, args.need("iterable", 0))
    start = args.get("start", 1)
    first = start.value if isinstance(start, Literal) else 0 if start is None else None
    if items is None or not isinstance(first, int) or isinstance(first, bool):
        return Unknown("enumerate", args.span)
    result = Sequence([], args.span, state.guards)
    for index, (guards, item) in enumerate(items, first):
        pair = Sequence([((), Literal(index, args.span)), ((), item)], args.span, state.guards)
        result.items.append((guards, pair))
    return result


def _zip(state: State, args: Arguments) -> Any:
    columns = [thing.plain() if isinstance(thing, Sequence) else None for thing in args.positional]
    if any(column is None for column in columns):
        return Unknown("zip", args.span)
    rows = [Sequence([((), item) for item in row], args.span, state.guards) for row in zip(*columns)]
    return Sequence([((), row) for row in rows], args.span, state.guards)


def _list(state: State, args: Arguments) -> Any:
    result = Sequence([], args.span, state.guards)
    if args.positional:
        extend(state, result, args.positional[0], ())
    return result


def _reversed(state: State, args: Arguments) -> Any:
    result = _list(state, args)
    result.items.reverse()
    return result


def _sorted(state: State, args: Arguments) -> Any:
    backwards = args.keywords.get("reverse")
    result = _list(state, args)
    if "key" in args.keywords:
        return result
    return in_order(result, isinstance(backwards, Literal) and bool(backwards.value))


def _dict(state: State, args: Arguments) -> Any:
    result = Mapping(args.span, open=args.more, base=state.guards)
    if args.positional:
        source = args.positional[0]
        items = source.plain() if isinstance(source, Sequence) else None
        for item in items or ():
            inner = item.plain() if isinstance(item, Sequence) else None
            if inner is None or len(inner) != 2:
                result.open = True
            else:
                put(state, result, inner[0], inner[1])
        if items is None:
            merge(state, result, source)
    for name, value in args.keywords.items():
        put(state, result, Literal(Located(name, args.span), args.span), value)
    return result


def _map(state: State, args: Arguments) -> Any:
    items = iterate(state, args.need("iterable", 1))
    if items is None or len(args.positional) != 2:
        return Unknown("map", args.span)
    function = args.positional[0]
    results = [(guards, state.call(function, [item], {}, False, args.span)) for guards, item in items]
    return Sequence(results, args.span, state.guards)


def _quiet(state: State, args: Arguments) -> Any:
    return Literal(None, args.span)


def _print(state: State, args: Arguments) -> Any:
    forget_printed(state, args.span)
    return Literal(None, args.span)


def _isinstance(state: State, args: Arguments) -> Any:
    thing, kind = args.get("obj", 0), args.get("type", 1)
    if isinstance(thing, Literal) and isinstance(kind, Symbol) and kind.name == "builtins.str":
        return Literal(isinstance(thing.value, str), args.span)
    return Unknown("isinstance", args.span)


def _first(state: State, args: Arguments) -> Any:
    """Functions that give back what they get."""
    thing = args.need("value", 0)
    return thing if isinstance(thing, (*VALUE_TYPES, Sequence, Mapping)) else Unknown("copy", args.span)


_PATHS = {
    "os.path.join": _join,
    "pathlib.Path": _path,
    "pathlib.PurePath": _path,
    "pathlib.PosixPath": _path,
    "os.path.dirname": _dirname,
    "os.path.basename": _basename,
    "os.path.abspath": _same_path,
    "os.path.realpath": _same_path,
    "os.path.normpath": _same_path,
    "os.fspath": _same_path,
    "os.path.exists": _exists,
    "os.path.isfile": _exists,
    "os.path.isdir": _exists,
    "os.path.expanduser": _noted("os.path.expanduser", "home folder"),
    "os.path.expandvars": _noted("os.path.expandvars", "environment in a path"),
    "pathlib.Path.home": _noted("os.path.expanduser", "home folder"),
    "ament_index_python.get_package_share_directory": _share,
    "ament_index_python.get_package_share_path": _share,
    "ament_index_python.get_package_prefix": _prefix,
    "os.environ.get": _getenv,
    "os.getenv": _getenv,
}

_BUILTINS = {
    "builtins.str": _str,
    "builtins.repr": _noted("repr", "repr"),
    "builtins.int": _number(int),
    "builtins.float": _number(float),
    "builtins.bool": _bool,
    "builtins.len": _length,
    "builtins.range": _range,
    "builtins.enumerate": _enumerate,
    "builtins.zip": _zip,
    "builtins.list": _list,
    "builtins.tuple": _list,
    "builtins.set": _list,
    "builtins.iter": _list,
    "builtins.reversed": _reversed,
    "builtins.sorted": _sorted,
    "builtins.dict": _dict,
    "collections.OrderedDict": _dict,
    "builtins.map": _map,
    "builtins.print": _print,
    "os.remove": _quiet,
    "os.unlink": _quiet,
    "os.makedirs": _quiet,
    "os.mkdir": _quiet,
    "os.chmod": _quiet,
    "shutil.rmtree": _quiet,
    "sys.path.append": _quiet,
    "sys.path.insert": _quiet,
    "builtins.isinstance": _isinstance,
    "builtins.open": _noted("open", "file contents"),
    "builtins.eval": _noted("eval", "eval"),
    "builtins.exec": _noted("exec", "exec"),
    "copy.copy": _first,
    "copy.deepcopy": _first,
    "os.system": _noted("os.system", "command"),
    "subprocess.run": _noted("subprocess.run", "command"),
    "subprocess.check_output": _noted("subprocess.check_output", "command"),
    "subprocess.Popen": _noted("subprocess.Popen", "command"),
    "xacro.process_file": _noted("xacro.process_file", "xacro output"),
    "xacro.process": _noted("xacro.process", "xacro output"),
    "yaml.safe_load": _noted("yaml.safe_load", "file contents"),
    "yaml.load": _noted("yaml.load", "file contents"),
    "logging.getLogger": _noted("logging.getLogger", "logger"),
    "time.sleep": _noted("time.sleep", "sleep"),
}

FUNCTIONS = {**_PATHS, **_BUILTINS}
