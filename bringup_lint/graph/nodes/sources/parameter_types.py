"""Of which type the parameters are that a Python source reads."""

from __future__ import annotations

import ast
from collections import Counter

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import Parameter
from bringup_lint.model.node_source import type_of_default
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_self

FIELDS = {"double_value": "double", "integer_value": "integer", "bool_value": "bool", "string_value": "string"}
"""The fields of a ParameterValue."""
_VALUE = "get_parameter_value"
_ANY_TYPE = ("dynamic_typing", "automatically_declare_parameters_from_overrides")
"""In a source that says so, a parameter may have another type than that of its default."""


def may_change(syntax: Syntax) -> bool:
    """Whether the parameters of a file may have other types than their defaults."""
    return syntax.once(_says_so)


def _says_so(syntax: Syntax) -> bool:
    return any(word in syntax.file.source.text for word in _ANY_TYPE)


def read_type(syntax: Syntax, value: ast.expr) -> str | None:
    """The type of ``self.get_parameter("name").value``, ``….get_parameter_value().double_value`` and
    ``self.declare_parameter("name", 0.5).value``, as ``type_of_default`` names it; None for all else, and where it is
    not known."""
    if not isinstance(value, ast.Attribute):
        return None
    if value.attr in FIELDS:
        return FIELDS[value.attr] if asked(value.value) is not None else None
    if value.attr != "value" or not isinstance(value.value, ast.Call) or may_change(syntax):
        return None
    if isinstance(value.value.func, ast.Attribute) and value.value.func.attr == "declare_parameter":
        name = _first_text(value.value)
    else:
        name = _got(value.value)
    cls = syntax.class_of(value) if name is not None else None
    return declared_type(syntax, cls.parameter(str(name)) if cls is not None else None)


def declared_type(syntax: Syntax, declared: Parameter | None) -> str | None:
    """The type of a parameter that a source declares once."""
    kind = type_of_default(declared.default) if declared is not None and declared.known else None
    return kind if declared is not None and not _is_declared_again(syntax, declared) else None


def asked(value: ast.expr) -> str | None:
    """The name in ``self.get_parameter("name").get_parameter_value()``."""
    outer = value.func if isinstance(value, ast.Call) else None
    if not isinstance(outer, ast.Attribute) or outer.attr != _VALUE or not isinstance(outer.value, ast.Call):
        return None
    return _got(outer.value)


def _got(call: ast.Call) -> str | None:
    """The name in ``self.get_parameter("name")``."""
    if not isinstance(call.func, ast.Attribute) or call.func.attr != "get_parameter" or len(call.args) != 1:
        return None
    return _first_text(call)


def _first_text(call: ast.Call) -> str | None:
    """The text that a method of ``self`` is given first."""
    if not isinstance(call.func, ast.Attribute) or not is_self(call.func.value) or not call.args:
        return None
    name = call.args[0]
    return name.value if isinstance(name, ast.Constant) and isinstance(name.value, str) else None


def _is_declared_again(syntax: Syntax, declared: Parameter) -> bool:
    """Whether a source declares the parameter in several places, for example one for each model of a device, or asks
    whether a class that it builds on has done so."""
    times = syntax.once(_declared)
    return times is None or times[declared.name] > 1


def _declared(syntax: Syntax) -> Counter[str] | None:
    """How often a source declares each parameter; None where it asks whether one is declared."""
    calls = [each for each in syntax.calls if each.args]
    if any(called_name(each) == "has_parameter" for each in calls):
        return None
    given = (each.args[0] for each in calls if called_name(each) == "declare_parameter")
    return Counter(each.value for each in given if isinstance(each, ast.Constant) and isinstance(each.value, str))
