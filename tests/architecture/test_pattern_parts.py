"""What a file says never becomes a part of a pattern as it is: names are escaped, or a name with a bracket in it would
end the question that asks for it.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

from tests.architecture.imports import syntax
from tests.conftest import PROJECT

ASKING = {"compile", "findall", "finditer", "fullmatch", "match", "regex", "search", "split", "sub", "subn"}
BUILDERS = {"bringup_lint/graph/purpose.py:words"}
"""Arguments of functions that make patterns of constants while a module is loaded."""
ESCAPES = ("escape", "_as_regex")
"""``_as_regex`` escapes what is not a wildcard of udev."""


def paths() -> list[str]:
    found = [*PROJECT.glob("bringup_lint/**/*.py"), *PROJECT.glob("rules/**/*.py")]
    return sorted(path.relative_to(PROJECT).as_posix() for path in found)


def functions(tree: ast.Module) -> Iterator[ast.Module | ast.FunctionDef]:
    yield tree
    yield from (node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef))


def asked(scope: ast.AST) -> Iterator[ast.expr]:
    """The patterns that code gives to ``re``."""
    for node in ast.walk(scope):
        if not isinstance(node, ast.Call) or not node.args:
            continue
        called = node.func
        of_re = isinstance(called, ast.Attribute) and isinstance(called.value, ast.Name) and called.value.id == "re"
        name = called.attr if isinstance(called, ast.Attribute) else getattr(called, "id", "")
        if name in ASKING and (of_re or name == "regex"):
            yield node.args[0]


def assigned(scope: ast.AST) -> dict[str, list[ast.expr]]:
    values: dict[str, list[ast.expr]] = {}
    for node in ast.walk(scope):
        if not isinstance(node, ast.Assign):
            continue
        for target in node.targets:
            names = target.elts if isinstance(target, ast.Tuple) else [target]
            for name in names:
                if isinstance(name, ast.Name):
                    values.setdefault(name.id, []).append(node.value)
    return values


def unescaped(part: ast.expr, values: dict[str, list[ast.expr]], seen: frozenset[str] = frozenset()) -> Iterator[str]:
    """The names that come into a pattern as they are."""
    if isinstance(part, ast.Constant) or any(f"{word}(" in ast.unparse(part) for word in ESCAPES):
        return
    if "re.escape" in ast.unparse(part) or (isinstance(part, ast.Attribute) and part.attr == "pattern"):
        return
    if isinstance(part, ast.Name):
        if part.id.isupper() or part.id in seen:
            return
        if part.id not in values:
            yield part.id
        for value in values.get(part.id, ()):
            yield from unescaped(value, values, seen | {part.id})
    elif isinstance(part, ast.JoinedStr | ast.BinOp | ast.IfExp):
        for child in ast.iter_child_nodes(part):
            value = child.value if isinstance(child, ast.FormattedValue) else child
            if isinstance(value, ast.expr) and not (isinstance(part, ast.IfExp) and value is part.test):
                yield from unescaped(value, values, seen)
    elif isinstance(part, ast.Call) and isinstance(part.func, ast.Attribute):
        of_constant = part.func.attr in ("format", "join", "get")
        for value in [*([] if of_constant else [part.func.value]), *part.args, *(each.value for each in part.keywords)]:
            yield from unescaped(value, values, seen)
    elif isinstance(part, ast.Attribute):
        if not part.attr.isupper():
            yield ast.unparse(part)
    elif isinstance(part, ast.Subscript):
        yield from unescaped(part.value, values, seen)
    elif isinstance(part, ast.Call):
        yield from (name for value in part.args for name in unescaped(value, values, seen))


def composed(pattern: ast.expr) -> bool:
    return isinstance(pattern, ast.JoinedStr | ast.BinOp) or (
        isinstance(pattern, ast.Call) and isinstance(pattern.func, ast.Attribute) and pattern.func.attr == "format"
    )


def parts(code: ast.Module) -> set[str]:
    found: set[str] = set()
    for scope in functions(code):
        values = assigned(scope)
        for pattern in asked(scope):
            if composed(pattern):
                found.update(unescaped(pattern, values) if scope is not code else ())
    return found


@pytest.mark.parametrize("text", ['re.search(rf"\\b{name}=", text)', "re.compile(USES.format(name=name))"])
def test_a_name_that_is_not_escaped_is_seen(text: str) -> None:
    assert parts(ast.parse(f"def asks(name, text):\n    return {text}\n")) == {"name"}


def test_a_name_that_is_escaped_before_is_known() -> None:
    assert not parts(ast.parse('def asks(name, text):\n    name = re.escape(name)\n    re.search(rf"{name}=", text)\n'))


def test_every_name_in_a_pattern_is_escaped() -> None:
    found = {f"{path}:{name}" for path in paths() for name in parts(syntax(PROJECT / path))}
    assert sorted(found - BUILDERS) == []
    assert found >= BUILDERS
