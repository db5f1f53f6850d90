"""The Python code of a tree: which of its files mention a name."""

from __future__ import annotations

import ast
import json
import os
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.uncalled.module import BY_NAME
from bringup_lint.graph.uncalled.module import PLAIN_BASES
from bringup_lint.graph.uncalled.module import USES
from bringup_lint.graph.uncalled.module import Module
from bringup_lint.graph.uncalled.words import Words
from bringup_lint.model.python import last_name
from bringup_lint.model.python import syntax_of
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_MOST = 5_000
"""Python files of a tree that is looked through."""
_ALL = 100_000_000
"""Characters of a tree that is looked through."""
_PARSED = 8_000_000
"""Characters of files that are parsed, and kept."""
_FILES = 40
"""Files that have a word: what more of them have is no name of its own."""
_SIZE = 1_000_000
"""How much is read of a file."""
_FIRST = 100
"""How much is read of a file to see what it is."""
_PYTHON = ("python-node", "launch-python", "setup-py")
_FILE = regex(r"\.(?:py|ipynb|pyi)$")
_SCRIPT = regex(r"(?:^|/)[^./]+$|\.in$")
"""Files whose first line may say that they are of Python."""
_STARTED = regex(r"#![^\n]*python", hints="#!")
_RUNNING = regex(r"(?:^|/)(?:pyproject\.toml|(?:GNU)?[Mm]akefile|[Jj]ustfile|Procfile)$")
"""Files of no kind that may name a function of Python."""
_FOREIGN = ("cpp-node", "cpp-driver", "cmake", "ros-package", "urdf")
"""Kinds that name no function of Python."""
_LOADING = ("launch-xml", "launch-yaml", "params", "urdf")
"""Kinds that may name a class to load it."""
_PROGRAM = regex(r"(?m)^(?:def main\b|if __name__\b)", hints="def if")
_MAGIC = regex(r"(?m)^([ \t]*)[%!?]")
_PART = regex(r"(?<=[.:/])\w+")
_OF_OTHERS = r"(?!(?:self|logging|socket|termios|np|numpy|torch|cv2|\w*[Mm]sg|args|parsed_args|options|Qt)\s*,)"
"""What is before the name that is computed where it may be of a class of the tree, and none of the one around."""
_REACHES = regex(
    r"\b(?:eval|exec)\(\s*f?[\"']|\bFire\(|\bregister_instance\(|\bzerorpc\.|\bjs_api\b|" + BY_NAME.format(_OF_OTHERS),
    hints="eval exec Fire( register_instance zerorpc js_api getattr setattr",
)
"""What may call any method by a name that it computes."""
_SETS = regex(
    r"\b(?:eval|exec)\(\s*f?[\"']|" + BY_NAME.replace("[gs]", "s").format(_OF_OTHERS), hints="eval exec setattr"
)
"""What may set any attribute so."""
_INSTALLED = regex(r"/(?:site|dist)-packages/")
_OF_CLASSES = frozenset({"dataclass", "final", "total_ordering"})
"""Decorators that hand a class to nobody."""


class Code:
    """The Python files of a tree, parsed where they are asked for."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._left = _PARSED

    @staticmethod
    def is_python(source: Source) -> bool:
        return source.kind in _PYTHON or source.name.endswith(".py")

    def module_of(self, source: Source) -> Module | None:
        return self._module((source.absolute, source.text))

    @memo
    def _module(self, asked: tuple[str, str]) -> Module | None:
        """The code of a file; None where it is refused, as a newer Python may accept it, and behind very many."""
        path, text = asked
        self._left -= len(text)
        if self._left < 0:
            return None
        tree = syntax_of(_cells(text) if path.endswith(".ipynb") else text.removeprefix("\ufeff"))
        return Module(path, text, tree) if tree is not None else None

    @cached_property
    def _texts(self) -> dict[str, str] | None:
        """Python files, and what they say; None where they are too many."""
        tree = self._files.tree
        paths = {os.path.abspath(path): path for path in tree.like(_FILE)}
        if len(paths) > _MOST:
            return None
        known = {
            each.absolute: each.text for each in self._files.sources if each.origin is None and self.is_python(each)
        }
        plain = {os.path.abspath(path): path for path in tree.like(_SCRIPT)[:_MOST]}
        scripts = {at: path for at, path in plain.items() if _STARTED.match(tree.head(path, _FIRST))}
        left = _ALL - sum(map(len, known.values()))
        for at, path in (paths | scripts).items():
            if at not in known:
                known[at] = tree.head(path, _SIZE)
                left -= len(known[at])
            if left < 0:
                return None
        return known

    @cached_property
    def has_programs(self) -> bool:
        """Whether a file of Python is a program: who runs the code may be looked for there."""
        return any(_PROGRAM.search(text) for text in (self._texts or {}).values())

    @cached_property
    def _words(self) -> Words:
        return Words(self._texts or {})

    @cached_property
    def _others(self) -> Words:
        """Files that may name a function of Python."""
        sources = (each for each in self._files.sources if each.kind not in _FOREIGN)
        pages = self._files.tree.pages(_RUNNING, _SIZE)
        texts = [*(each.text for each in sources if not self.is_python(each)), *pages]
        return Words({str(at): text for at, text in enumerate(texts)})

    @cached_property
    def reaches_by_name(self) -> bool:
        """Whether a file of the tree may call whatever it likes of what it is given."""
        return any(map(_REACHES.search, self._own_texts))

    @cached_property
    def sets_by_name(self) -> bool:
        """Whether a file of the tree may set whatever it likes of what it is given."""
        return any(map(_SETS.search, self._own_texts))

    @property
    def _own_texts(self) -> Iterator[str]:
        return (text for at, text in (self._texts or {}).items() if not _INSTALLED.search(at))

    @memo
    def is_loaded(self, cls: ast.ClassDef) -> bool:
        """Whether something may use a class by its name or through a decorator, and call what it likes of it."""
        if cls.name in self._loaded:
            return True
        if any(last_name(getattr(each, "func", each)) not in _OF_CLASSES for each in cls.decorator_list):
            return True
        modules = self.modules_with(cls.name)
        return modules is None or any(each.is_reflected for each in modules)

    @cached_property
    def _loaded(self) -> frozenset[str]:
        """What files that load something name as a part of something else."""
        texts = (each.text for each in self._files.of_kind(*_LOADING))
        return frozenset(name for text in texts for name in _PART.findall(text))

    def _having(self, word: str) -> list[str] | None:
        """The Python files that have a word; None when they are too many."""
        found = self._words.having(word) if self._texts is not None else []
        return found if self._texts is not None and len(found) <= _FILES else None

    @memo
    def modules_with(self, word: str) -> list[Module] | None:
        """The modules that have a word; None when they are too many, or one cannot be read."""
        having = self._having(word)
        found = [self._module((name, (self._texts or {})[name])) for name in having or ()]
        modules = [each for each in found if each is not None]
        return modules if having is not None and len(modules) == len(found) else None

    def mentions(self, name: str, first: Module) -> Iterator[tuple[Module, ast.expr]] | None:
        """The places that may use a function or class, but for its definition and plain imports, those of one module
        first; None when unknown, as where a comment puts away a call that somebody may bring back."""
        having = self._having(name)
        if having is None or self._others.having(name) or any(name in self._words.put_away(each) for each in having):
            return None
        return self._used(name, sorted(having, key=lambda each: each != first.path))

    def _used(self, name: str, having: list[str]) -> Iterator[tuple[Module, ast.expr]]:
        for each in having:
            text = (self._texts or {})[each]
            module = self._module((each, text))
            uses = module.uses.get(name, ()) if module is not None and name not in module.renamed else None
            if module is None or uses is None or len(uses) > USES:
                yield Module(each, text, ast.Module([], [])), ast.Name(name, lineno=0)
            else:
                yield from ((module, use) for use in uses)

    @memo
    def has_known_bases(self, cls: ast.ClassDef) -> bool:
        """Whether nothing that a class builds on may call its methods unseen."""
        return not cls.keywords and all(self._is_known((last_name(base), 4)) for base in cls.bases)

    @staticmethod
    def is_node(cls: ast.ClassDef) -> bool:
        """Whether a class builds on a plain node, and on nothing else."""
        return [last_name(base) for base in cls.bases] == ["Node"]

    def ancestors(self, cls: ast.ClassDef) -> frozenset[str]:
        """The names of the classes of the tree that a class builds on."""
        return frozenset(each.name for _, each in self.bases(cls))

    @memo
    def bases(self, cls: ast.ClassDef) -> list[tuple[Module, ast.ClassDef]]:
        """The classes of the tree that a class with known bases builds on, also through each other."""
        found: dict[str, list[tuple[Module, ast.ClassDef]]] = {}
        todo = [last_name(base) for base in cls.bases]
        while todo:
            name = todo.pop()
            if name in found or name in PLAIN_BASES:
                continue
            modules = self.modules_with(name) or ()
            found[name] = [(module, each) for module in modules for each in module.classes.get(name, ())]
            todo += [last_name(base) for _, each in found[name] for base in each.bases]
        return [each for classes in found.values() for each in classes]

    @memo
    def _is_known(self, asked: tuple[str, int]) -> bool:
        name, depth = asked
        if name in PLAIN_BASES:
            return True
        modules = self.modules_with(name) if name and depth else None
        found = [(module, each) for module in modules or () for each in module.classes.get(name, ())]
        return bool(found) and not any(
            module.is_reflected
            or each.keywords
            or not all(self._is_known((last_name(inner), depth - 1)) for inner in each.bases)
            for module, each in found
        )


def _cells(text: str) -> str:
    """The code of a notebook, but for cells that are no Python."""
    try:
        cells = json.loads(text)["cells"]
        code = ["".join(each["source"]) for each in cells if each["cell_type"] == "code"]
    except (ValueError, KeyError, TypeError, RecursionError):
        return ""
    return "\n".join(each for each in (_MAGIC.sub(r"\1pass #", one) for one in code) if syntax_of(each) is not None)
