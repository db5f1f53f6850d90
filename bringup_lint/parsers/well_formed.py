"""Whether a text is what the name of its file says: Python, XML, YAML, JSON or TOML."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.source import Source
from bringup_lint.toml import read_toml


def is_well_formed(source: Source) -> bool:
    """Whether a file can be read; true of a file in another form."""
    ending = source.basename.rpartition(".")[2]
    form = next((form for form, endings in _ENDINGS.items() if ending in endings), "")
    if not form and source.kind.startswith("launch-"):
        form = source.kind.removeprefix("launch-")
    return form not in _READERS or _READERS[form](source)


def _python(source: Source) -> bool:
    """Compiled, for Python finds a repeated keyword only then; nothing runs."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            compile(source.text.removeprefix("\ufeff"), source.name, "exec", dont_inherit=True)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return True


def _xml(source: Source) -> bool:
    from bringup_lint.parsers.xml import parse

    return not parse(source).problems


def _yaml(source: Source) -> bool:
    from bringup_lint.parsers.yaml_nodes import parse

    file = parse(source, follow_aliases=False)
    return not file.problems and not any(_repeats(document.root) for document in file.documents)


def _repeats(root: Node | None) -> bool:
    """Whether a mapping has a key twice."""
    return any(next(mapping.duplicates, None) is not None for mapping in _mappings(root))


def _mappings(root: Node | None) -> Iterator[Mapping]:
    to_do = [root]
    while to_do:
        node = to_do.pop()
        if isinstance(node, Mapping):
            yield node
            to_do += (value for _, value in node.pairs)
        elif isinstance(node, Sequence):
            to_do += node.items


def _json(source: Source) -> bool:
    return _loads(json.loads, source.text)


def _toml(source: Source) -> bool:
    return _loads(read_toml, source.text)


def _loads(load: Callable[[str], object], text: str) -> bool:
    try:
        load(text)
    except (ValueError, RecursionError):
        return False
    return True


_ENDINGS = {
    "python": ("py",),
    "xml": ("xml", "launch", "urdf", "xacro"),
    "yaml": ("yaml", "yml"),
    "json": ("json",),
    "toml": ("toml",),
}
_READERS = {"python": _python, "xml": _xml, "yaml": _yaml, "json": _json, "toml": _toml}
