"""Only ``discover/`` touches the tree that is checked: what else needs to know asks ``Tree``."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator
from pathlib import Path

from tests.architecture.imports import PACKAGE
from tests.architecture.imports import nodes
from tests.architecture.imports import paths
from tests.conftest import PROJECT

ALLOWED = {
    "discover": "reads the tree",
    "cache": "keeps answers in a folder of the user, and looks whether the program is the same",
    "cli": "reads what the command line names, and writes reports",
    "live": "starts the process that looks at the running graph",
    "fleet": "reads the inventory, and asks whether there is what it names",
    "registry.py": "loads the rules",
    "importing.py": "imports the modules of the program",
    "on_demand.py": "reads the imports of its modules",
    "rule_index": "keeps what the rules say of themselves",
    "fix.py": "asks whether a file is a link before it is corrected",
    "writing.py": "writes corrected files and reports",
    "facts/__init__.py": "reads the tables of the package",
}
MODULES = frozenset(("pathlib", "shutil", "glob", "tempfile", "subprocess", "fileinput", "mmap"))
OF_OS = frozenset(
    "access chmod chown fdopen fstat link listdir lstat makedirs mkdir open readlink remove removedirs rename renames "
    "replace rmdir scandir stat statvfs symlink truncate unlink utime walk fwalk".split()
)
OF_OS_PATH = frozenset(
    "exists expanduser getatime getctime getmtime getsize isdir isfile islink ismount lexists realpath samefile".split()
)


def accesses(path: Path) -> Iterator[str]:
    """What a module imports and calls that touches the disk."""
    for node in nodes(path):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name in MODULES)
        elif isinstance(node, ast.ImportFrom):
            if node.module in MODULES or (node.module in ("os", "os.path") and node.names):
                yield str(node.module)
        elif isinstance(node, ast.Attribute) and (node.attr in OF_OS or node.attr in OF_OS_PATH):
            name = ast.unparse(node)
            if (name.startswith("os.") and name[3:] in OF_OS) or (
                name.startswith("os.path.") and name[8:] in OF_OS_PATH
            ):
                yield name
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "open":
            yield "open"


def is_allowed(path: Path) -> bool:
    name = path.relative_to(PACKAGE)
    return str(name) in ALLOWED or name.parts[0] in ALLOWED


def touching(files: Iterable[Path]) -> dict[Path, list[str]]:
    """The files that touch the disk, with how they do."""
    found = {path: list(accesses(path)) for path in files}
    return {path: names for path, names in found.items() if names}


def test_the_package_asks_the_tree() -> None:
    assert touching(path for path in paths() if not is_allowed(path)) == {}


def test_rules_ask_the_tree() -> None:
    assert touching(sorted((PROJECT / "rules").rglob("*.py"))) == {}


def test_every_exception_is_needed() -> None:
    assert [name for name in ALLOWED if not any(map(_touches, sorted(_files_of(PACKAGE / name))))] == []


def _files_of(place: Path) -> list[Path]:
    return list(place.rglob("*.py")) if place.is_dir() else [place]


def _touches(path: Path) -> bool:
    return any(accesses(path))
