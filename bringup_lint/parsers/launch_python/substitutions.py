"""Substitutions, conditions and parameter descriptions of launch and launch_ros."""

from __future__ import annotations

from typing import Any

from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.functions import join_path
from bringup_lint.parsers.launch_python.objects import LaunchSource
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Placed
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import Builder
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.unperformed import is_text
from bringup_lint.parsers.launch_python.unperformed import note_object
from bringup_lint.source import Located


def _configuration(state: State, args: Arguments) -> Any:
    name = freeze.text(state, args.need("variable_name", 0))
    default = freeze.optional_text(state, args.get("default", 1))
    if not isinstance(name, Literal) or not isinstance(name.value, Located):
        state.file.reads_all = True
        return Unknown("name of a launch configuration", args.span)
    result = Argument(name.value, default, args.span)
    state.file.reads.append(result)
    return result


def _as_bool(state: State, args: Arguments) -> Any:
    inner = _configuration(state, args)
    return Operation("as-bool", (inner,), args.span) if isinstance(inner, Argument) else inner


def _environment(state: State, args: Arguments) -> Any:
    name = freeze.text(state, args.need("name", 0))
    default = freeze.optional_text(state, args.get("default_value", 1))
    if isinstance(name, Literal) and isinstance(name.value, Located):
        return Env(name.value, default, args.span, scoped=True)
    return Unknown("environment", args.span)


def _join(state: State, args: Arguments) -> Any:
    thing = args.need("substitutions", 0)
    items = thing.plain() if isinstance(thing, Sequence) else None
    if items is None:
        return Unknown("path", args.span)
    parts = [freeze.text(state, item) for item in items]
    return join_path(state, parts, args.span) if parts else Literal(Located("", args.span), args.span)


def _share(state: State, args: Arguments) -> Any:
    return PackageShare(freeze.text(state, args.need("package", 0)), args.span)


def _prefix(state: State, args: Arguments) -> Any:
    return PackagePrefix(freeze.text(state, args.need("package", 0)), args.span)


def _executable_in_package(state: State, args: Arguments) -> Any:
    package = freeze.text(state, args.need("package", 1))
    executable = freeze.text(state, args.need("executable", 0))
    lib = Literal(Located("lib", args.span), args.span)
    return PathJoin((PackagePrefix(package, args.span), lib, package, executable), args.span)


def _text(state: State, args: Arguments) -> Any:
    return freeze.text(state, args.need("text", 0))


def _found(state: State, args: Arguments) -> Any:
    """``FindExecutable``: the name stands for the program."""
    return freeze.text(state, args.need("name", 0))


def _command(state: State, args: Arguments) -> Any:
    return Command(freeze.text(state, args.need("command", 0)), args.span)


def _python(state: State, args: Arguments) -> Any:
    if args.get("python_modules", 1) is not None:
        return Unknown("an expression with modules", args.span)
    result = Operation("python", (freeze.text(state, args.need("expression", 0)),), args.span)
    state.file.expressions.append(result)
    return result


def _operation(name: str, *parameters: str) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        operands = [freeze.text(state, args.need(word, index)) for index, word in enumerate(parameters)]
        return budget.bounded(Operation(name, tuple(operands), args.span))

    return builder


def _any_of(name: str) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        operands = [freeze.text(state, thing) for thing in args.positional]
        if len(operands) == 1 and isinstance(args.positional[0], Sequence):
            operands = list(freeze.values(state, args.positional[0]))
        return budget.bounded(Operation(name, tuple(operands), args.span))

    return builder


def _if_else(state: State, args: Arguments) -> Any:
    empty = Literal(Located("", args.span), args.span)
    operands = [freeze.text(state, args.need("condition", 0))]
    for index, word in enumerate(("if_value", "else_value"), 1):
        thing = args.get(word, index)
        operands.append(empty if thing is None else freeze.text(state, thing))
    return budget.bounded(Operation("if", tuple(operands), args.span))


def _this_file(itself: bool) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        return FileDir(args.span, itself)

    return builder


def _condition(wanted: bool) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        predicate = freeze.text(state, args.need("predicate_expression", 0))
        kind = "if" if wanted else "unless"
        return Placed(Condition(predicate, wanted, kind, args.span), args.span)

    return builder


def _equals_condition(wanted: bool) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        name = args.get("launch_configuration_name", 0)
        expected = freeze.text(state, args.need("expected_value", 1))
        span = args.span
        if not isinstance(name, Literal) or not isinstance(name.value, Located):
            note_object(state, "configuration-name", name, span)
            return Placed(Condition(Unknown("launch configuration", span), wanted, "if", span), span)
        argument = Argument(name.value, None, name.span)
        state.file.reads.append(argument)
        return Placed(Condition(Operation("==", (argument, expected), span), wanted, "if", span), span)

    return builder


def _launch_source(state: State, args: Arguments) -> Any:
    thing = args.need("launch_file_path", 0)
    return LaunchSource(freeze.text(state, thing), args.span)


def _parameter_file(state: State, args: Arguments) -> Any:
    file = freeze.text(state, args.need("param_file", 0))
    allow = args.get("allow_substs")
    return ParameterFile(file, None if allow is None else freeze.text(state, allow), args.span)


def _parameter_value(state: State, args: Arguments) -> Any:
    kind = args.get("value_type", 1)
    word = kind.name.rpartition(".")[2] if isinstance(kind, Symbol) else ""
    return TypedValue(parameter(state, args.need("value", 0)), word, args.span)


def parameter(state: State, thing: Any) -> Any:
    """A parameter's value: a list of substitutions and strings is one text, as launch_ros takes it."""
    value = freeze.value(state, thing)
    items = thing.plain() if isinstance(thing, Sequence) else None
    if items:
        texts = [isinstance(item, Literal) and isinstance(item.value, str) for item in items]
        symbolic = [not isinstance(item, (Literal, Sequence, Mapping, Unknown)) and not is_text(item) for item in items]
        if any(symbolic) and all(a or b for a, b in zip(texts, symbolic)):
            return freeze.text(state, thing)
    return value


def _named_parameter(state: State, args: Arguments) -> Any:
    """``Parameter(name, value)``: a dictionary of one."""
    result = Mapping(args.span)
    name = args.need("name", 0)
    result.entries[getattr(name, "value", "")] = (freeze.text(state, name), args.need("value", 1))
    return result


def _derived(helper: str) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        base = freeze.text(state, args.need("source_file", 0))
        rewrites = args.get("param_rewrites", 1) or args.get("replacements", 1)
        root_key = freeze.optional_text(state, args.get("root_key", 2 if helper == "RewrittenYaml" else None))
        frozen = None if rewrites is None else freeze.value(state, rewrites)
        if args.get("key_rewrites", 3) is not None or args.get("value_rewrites") is not None:
            frozen = Unknown("other rewrites", args.span)
        return DerivedFile(base, helper, frozen, root_key, args.span)

    return builder


def _global_parameter(state: State, args: Arguments) -> Any:
    return Unknown("a parameter of the launch context", args.span)


def _without_text(why: str) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        return Unknown(why, args.span)

    return builder


def _joined(state: State, args: Arguments) -> Any:
    """``StringJoinSubstitution``."""
    thing = args.need("substitutions", 0)
    delimiter = args.get("delimiter", 1)
    items = thing.plain() if isinstance(thing, Sequence) else None
    if items is None:
        return Unknown("text", args.span)
    parts: list[Any] = []
    for item in items:
        if parts and delimiter is not None:
            parts.append(freeze.text(state, delimiter))
        parts.append(freeze.text(state, item))
    return budget.concat(parts, args.span) if parts else Literal(Located("", args.span), args.span)


SUBSTITUTIONS = {
    "launch.LaunchConfiguration": _configuration,
    "launch.LaunchConfigAsBool": _as_bool,
    "launch.EnvironmentVariable": _environment,
    "launch.PathJoinSubstitution": _join,
    "launch.PathSubstitution": _text,
    "launch.StringJoinSubstitution": _joined,
    "launch.FindPackageShare": _share,
    "launch.FindPackagePrefix": _prefix,
    "launch.FindPackage": _prefix,
    "launch.ExecutableInPackage": _executable_in_package,
    "launch.TextSubstitution": _text,
    "launch.FindExecutable": _found,
    "launch.Command": _command,
    "launch.PythonExpression": _python,
    "launch.AndSubstitution": _operation("and", "left", "right"),
    "launch.OrSubstitution": _operation("or", "left", "right"),
    "launch.AllSubstitution": _any_of("and"),
    "launch.AnySubstitution": _any_of("or"),
    "launch.NotSubstitution": _operation("not", "value"),
    "launch.EqualsSubstitution": _operation("equals", "left", "right"),
    "launch.NotEqualsSubstitution": _operation("not-equals", "left", "right"),
    "launch.IfElseSubstitution": _if_else,
    "launch.ThisLaunchFile": _this_file(True),
    "launch.ThisLaunchFileDir": _this_file(False),
    "launch.IfCondition": _condition(True),
    "launch.UnlessCondition": _condition(False),
    "launch.LaunchConfigurationEquals": _equals_condition(True),
    "launch.LaunchConfigurationNotEquals": _equals_condition(False),
    "launch.PythonLaunchDescriptionSource": _launch_source,
    "launch.AnyLaunchDescriptionSource": _launch_source,
    "launch.FrontendLaunchDescriptionSource": _launch_source,
    "launch.XMLLaunchDescriptionSource": _launch_source,
    "launch.YAMLLaunchDescriptionSource": _launch_source,
    "launch.ParameterFile": _parameter_file,
    "launch.ParameterValue": _parameter_value,
    "launch.Parameter": _named_parameter,
    "launch.substitutions.Parameter": _global_parameter,
    "launch.RewrittenYaml": _derived("RewrittenYaml"),
    "launch.ReplaceString": _derived("ReplaceString"),
    "launch.LaunchLogDir": _without_text("log folder"),
    "launch.AnonName": _without_text("anonymous name"),
    "launch.LocalSubstitution": _without_text("event value"),
    "launch.HasNodeParams": _without_text("contents of a parameter file"),
}
