"""The layers: each may import only what stands to its right; heavy libraries load only where they are needed."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import PROJECT

PACKAGE = PROJECT / "bringup_lint"
LAYERS = (
    {"__main__"},
    {"cli"},
    {"finish"},
    {"engine"},
    {"fix", "baseline", "suppress", "config", "registry"},
    {"report", "live"},
    {"api"},
    {"robot"},
    {"graph"},
    {"discover"},
    {"parsers"},
    {"schema"},
    {"model", "finding", "facts"},
    {"source", "spelling", "templates", "toml"},
)
LEVEL = {name: level for level, names in enumerate(LAYERS) for name in names}
HEAVY = ("networkx", "yaml", "pathspec", "click", "jsonschema", "lxml")


def modules() -> list[Path]:
    return sorted(
        path for path in PACKAGE.rglob("*.py") if path != PACKAGE / "__init__.py" and "rules" not in path.parts
    )


def layer_of(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def imports(path: Path, *, at_import_time: bool = True) -> set[str]:
    """The modules that a file imports; what only a type checker sees does not count."""
    found = set()

    def visit(node: ast.AST) -> None:
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
            return
        if at_import_time and isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            return
        if isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module)
        if isinstance(node, ast.Import):
            found.update(alias.name for alias in node.names)
        for child in ast.iter_child_nodes(node):
            visit(child)

    visit(ast.parse(path.read_text("utf-8")))
    return found


@pytest.mark.parametrize("path", modules(), ids=lambda path: str(path.relative_to(PACKAGE)))
def test_imports_point_to_the_right(path: Path) -> None:
    own = layer_of(path)
    for module in imports(path, at_import_time=False):
        if module.startswith("bringup_lint."):
            other = module.split(".")[1]
            assert other == own or LEVEL[other] > LEVEL[own], f"{own} may not import {module}"


def loaded_after(code: str) -> set[str]:
    script = f"{code}\nimport sys; print(' '.join(m for m in {HEAVY!r} if m in sys.modules))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=PROJECT, check=True)
    return set(run.stdout.splitlines()[-1].split())


def test_version_loads_nothing_heavy() -> None:
    code = "import sys; sys.argv = ['bringup-lint', '--version']\nfrom bringup_lint.__main__ import main; main()"
    assert loaded_after(code) == set()


def test_one_unit_loads_no_xml_yaml_or_graph_library(tmp_path: Path) -> None:
    unit = tmp_path / "robot.service"
    unit.write_text("[Service]\nExecStart=/bin/true\n")
    code = f"""from bringup_lint.cli import dispatch
try: dispatch([{str(unit)!r}])
except SystemExit: pass"""
    assert loaded_after(code) <= {"click"}
