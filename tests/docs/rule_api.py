"""``docs/rule-api.md``: what a rule may ask, read from the source with types, docstrings and lines of real rules."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cache
from inspect import cleandoc
from pathlib import Path
from typing import NamedTuple

from tests.conftest import PROJECT

PACKAGE = PROJECT / "bringup_lint"
PAGE = PROJECT / "docs" / "rule-api.md"
HEAD = """\
# What a rule may ask

A rule imports from `bringup_lint.api` and its modules, gets a `Robot`, and yields findings; CONTRIBUTING.md shows a
whole one. This page is made from the docstrings of the code and from lines of the rules by
`pytest tests/docs/test_rule_api.py --update-expected`.

Values that come from a file are `Located`: strings with a `span`. Pass them to `finding`, `note` and `fix` as they are.
"""


class Entry(NamedTuple):
    """One name that a rule can use."""

    signature: str
    doc: str


class Class(NamedTuple):
    """A class with what is public of it."""

    doc: str
    members: dict[str, Entry]


@cache
def page() -> str:
    robot = class_of("Robot", PACKAGE / "robot.py")
    parts = [
        HEAD,
        "## Findings\n",
        *_entries(functions(PACKAGE / "api/__init__.py", ("rule", "finding", "note", "fix"))),
        *_entries(functions(PACKAGE / "pattern.py", ("regex",))),
    ]
    parts += ["\n## The robot\n", robot.doc, ""]
    for name, entry in robot.members.items():
        parts += _member("robot", name, entry)
    for path in sorted((PACKAGE / "api").glob("*.py")):
        if path.stem != "__init__":
            parts += _module(path)
    return re.sub(r"\n{3,}", "\n\n", "\n".join(parts)).rstrip() + "\n"


def _member(owner: str, name: str, entry: Entry) -> Iterator[str]:
    """A member of the robot, and where it is a layer, what the layer offers."""
    yield f"\n### `{owner}.{entry.signature}`\n"
    yield entry.doc
    if example := example_of(name, rf"\b{owner}\.{name}\b"):
        yield f"\n{example}"
    layer = _layer(entry.signature)
    if layer is not None:
        yield f"\n{layer.doc}\n" if layer.doc else ""
        yield from _entries(layer.members)


def _module(path: Path) -> Iterator[str]:
    tree = ast.parse(path.read_text("utf-8"))
    yield f"\n## `bringup_lint.api.{path.stem}`\n"
    yield cleandoc(ast.get_docstring(tree) or "")
    yield ""
    for name, (origin, original) in sorted(_exports(path).items()):
        entry = _entry_of(original, origin)
        line = f"- `{entry.signature}`" + (f": {entry.doc}" if entry.doc else "")
        used = rf"\b(?:{path.stem}\.)?{name}\b[(.]"
        example = example_of(name, used, f"api.{path.stem} import {name}$|api import {path.stem}$")
        yield line + (f"\n  {example}" if example else "")


def _entries(members: dict[str, Entry]) -> Iterator[str]:
    for entry in members.values():
        yield f"- `{entry.signature}`" + (f": {entry.doc}" if entry.doc else "")


def functions(path: Path, names: Iterable[str]) -> dict[str, Entry]:
    nodes = {node.name: node for node in _tree(path).body if isinstance(node, ast.FunctionDef)}
    return {name: Entry(_signature(nodes[name]), _doc(nodes[name])) for name in names}


@cache
def class_of(name: str, path: Path) -> Class:
    """The public fields, properties and methods of a class, those that it inherits from the package too."""
    node = next(node for node in _tree(path).body if isinstance(node, ast.ClassDef) and node.name == name)
    members: dict[str, Entry] = {}
    for base in node.bases:
        where = _imports(path).get(ast.unparse(base))
        if where is not None and where[1] != "NamedTuple":
            members |= class_of(where[1], where[0]).members
    for at, item in enumerate(node.body):
        if isinstance(item, ast.FunctionDef) and not item.name.startswith("_"):
            members[item.name] = Entry(_signature(item), _doc(item))
        elif isinstance(item, ast.AnnAssign) and isinstance(item.target, ast.Name) and item.target.id[0] != "_":
            members[item.target.id] = Entry(f"{item.target.id}: {ast.unparse(item.annotation)}", _text_below(node, at))
    return Class(_doc(node), members)


def _text_below(node: ast.ClassDef, at: int) -> str:
    """The docstring below a field."""
    after = node.body[at + 1] if at + 1 < len(node.body) else None
    if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant) and isinstance(after.value.value, str):
        return _first(after.value.value)
    return ""


def _layer(signature: str) -> Class | None:
    """The class that a member of the robot gives, when it is one of the graph's."""
    for name in re.findall(r"\b[A-Z]\w+", signature.rpartition(": ")[2].rpartition("-> ")[2]):
        where = _imports(PACKAGE / "robot.py").get(name)
        if where is not None and "graph" in where[0].parts:
            return class_of(where[1], where[0])
    return None


def _entry_of(name: str, path: Path) -> Entry:
    """A name of a module: a function, a class, a constant, or a name that the module imports itself."""
    if path.stem == name and not any(getattr(node, "name", "") == name for node in _tree(path).body):
        return Entry(f"{name} (module)", _first(ast.get_docstring(_tree(path)) or ""))
    body = _tree(path).body
    for at, node in enumerate(body):
        if isinstance(node, ast.FunctionDef) and node.name == name:
            return Entry(_signature(node), _doc(node))
        if isinstance(node, ast.ClassDef) and node.name == name:
            return Entry(f"class {name}", _doc(node))
        if isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            if any(isinstance(target, ast.Name) and target.id == name for target in targets):
                return Entry(name, _text_below(ast.ClassDef("", [], [], body, []), at))
    where = _imports(path).get(name)
    return _entry_of(where[1], where[0]) if where is not None else Entry(name, "")


@cache
def _tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text("utf-8"))


@cache
def _imports(path: Path) -> dict[str, tuple[Path, str]]:
    """Imported name -> the file of the package that it comes from, and its name there."""
    found = {}
    for node in ast.walk(_tree(path)):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("bringup_lint"):
            for alias in node.names:
                found[alias.asname or alias.name] = (_file(node.module or "", alias.name), alias.name)
    return found


def _exports(path: Path) -> dict[str, tuple[Path, str]]:
    for node in _tree(path).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__":
            names = ast.literal_eval(node.value)
            return {name: _imports(path).get(name, (path, name)) for name in names}
    return {}


def _file(module: str, name: str) -> Path:
    base = PROJECT.joinpath(*module.split("."))
    for path in (base / f"{name}.py", base.with_suffix(".py"), base / "__init__.py"):
        if path.is_file():
            return path
    raise FileNotFoundError(f"{module}.{name}")


def _signature(node: ast.FunctionDef) -> str:
    """``name(arguments) -> type``; for a property ``name: type``."""
    returns = ast.unparse(node.returns) if node.returns else ""
    if any("property" in ast.unparse(decorator) for decorator in node.decorator_list):
        return f"{node.name}: {returns}"
    arguments = ast.unparse(node.args)
    arguments = re.sub(r"^self(?:, )?", "", arguments)
    return f"{node.name}({arguments})" + (f" -> {returns}" if returns else "")


def _doc(node: ast.FunctionDef | ast.ClassDef) -> str:
    return _first(ast.get_docstring(node) or "")


def _first(doc: str) -> str:
    """The first paragraph, as one line."""
    return " ".join(cleandoc(doc).partition("\n\n")[0].split()).replace("``", "`")


@cache
def _rules() -> list[tuple[str, str]]:
    """The id and the code of every rule, without its documentation."""
    found = []
    for path in sorted((PROJECT / "rules").glob("*/*.py")):
        text = path.read_text("utf-8")
        code = text.split('"""', 2)[2]
        found.append((f"{path.parent.name}/{path.stem}".replace("_", "-"), code))
    return found


def example_of(name: str, pattern: str, imports: str = "") -> str:
    """The shortest line of a rule that uses a name as the pattern says, with the rule's id."""
    lines = [
        (len(line.strip()), line.strip(), rule)
        for rule, code in _rules()
        if name in code and (not imports or re.search(imports, code, re.M))
        for line in code.splitlines()
        if name in line and len(line.strip()) > 24
        if re.search(pattern, line) and not re.match(r"\s*(?:from|import|def|@)\b", line)
    ]
    if not lines:
        return ""
    _, line, rule = min(lines)
    path = "../rules/" + rule.replace("-", "_") + ".py"
    return f"Example, [{rule}]({path}): `{line}`"
