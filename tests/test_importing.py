"""Modules are imported as Python would import them."""

from __future__ import annotations

import os
import subprocess
import sys
from importlib.machinery import SourceFileLoader
from importlib.util import cache_from_source
from pathlib import Path

import pytest

from bringup_lint.importing import Loader
from tests.conftest import PROJECT


def value(folder: Path, loader: type[SourceFileLoader] = Loader) -> object:
    path = str(folder / "each.py")
    names: dict[str, object] = {}
    code = loader("each", path).get_code("each")
    assert code is not None
    exec(code, names)
    return names["VALUE"]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    (tmp_path / "each.py").write_text("VALUE = 1\n")
    os.utime(tmp_path / "each.py", (1000, 1000))
    assert value(tmp_path, SourceFileLoader) == 1
    assert Path(cache_from_source(str(tmp_path / "each.py"))).is_file()
    return tmp_path


def test_byte_code_of_the_file_is_taken(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(SourceFileLoader, "get_code", None)
    assert value(folder) == 1


@pytest.mark.parametrize("other", [b"VALUE = 23\n", b"VALUE = 2\n"])
def test_byte_code_of_an_earlier_text_is_not_taken(folder: Path, other: bytes) -> None:
    (folder / "each.py").write_bytes(other)
    assert value(folder) == int(other.split()[-1])


@pytest.mark.parametrize("data", [b"", b"\0" * 16, b"\0" * 400])
def test_what_is_no_byte_code_is_not_taken(folder: Path, data: bytes) -> None:
    Path(cache_from_source(str(folder / "each.py"))).write_bytes(data)
    assert value(folder) == 1


def test_byte_code_that_is_cut_off_is_refused_as_by_python(folder: Path) -> None:
    cached = Path(cache_from_source(str(folder / "each.py")))
    cached.write_bytes(cached.read_bytes()[:-8])
    with pytest.raises(EOFError):
        value(folder, SourceFileLoader)
    with pytest.raises(EOFError):
        value(folder)


@pytest.mark.parametrize("option", [(), ("-O",), ("-X", "pycache_prefix=elsewhere"), ("-B",), ("-I",)])
def test_modules_know_where_they_are_from(tmp_path: Path, option: tuple[str, ...]) -> None:
    program = (
        f"import sys; sys.path.insert(0, {str(PROJECT)!r})\n"
        "from bringup_lint.importing import import_directly; import_directly()\n"
        "import bringup_lint.graph.graph as each\n"
        "import bringup_lint.parsers, html\n"
        "print(each.__file__, each.__name__, each.__package__, bringup_lint.parsers.__path__[0])\n"
    )
    run = subprocess.run([sys.executable, *option, "-c", program], cwd=tmp_path, capture_output=True, text=True)
    package = PROJECT / "bringup_lint"
    expected = f"{package}/graph/graph.py bringup_lint.graph.graph bringup_lint.graph {package}/parsers\n"
    assert (run.stdout, run.stderr) == (expected, "")


def test_a_module_that_is_not_there_is_told_as_by_python() -> None:
    program = (
        f"import sys; sys.path.insert(0, {str(PROJECT)!r})\n"
        "from bringup_lint.importing import import_directly; import_directly()\n"
        "import bringup_lint.no_such_module\n"
    )
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
    assert "ModuleNotFoundError: No module named 'bringup_lint.no_such_module'" in run.stderr
