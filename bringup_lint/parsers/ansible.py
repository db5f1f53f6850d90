"""Ansible's tasks and cloud-init's user data, as far as they put files on a machine (the modules copy, template,
blockinfile and lineinfile; ``write_files``)."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import replace
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.ansible_tasks import modules
from bringup_lint.parsers.yaml_nodes import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_MODULES = frozenset({"copy", "template", "blockinfile", "lineinfile"})
_CONTENTS = {"content": False, "block": True, "line": True}
"""Key that holds the text of a file -> whether the text is added to the file."""
_VARIABLE = regex(r"\{\{ *(?P<name>\w+) *\}\}")

_ITEM = regex(r"\{\{ *(?P<name>item(?:\.\w+)?) *\}\}")


class Put(NamedTuple):
    """A file that a task puts on the machine."""

    path: Located
    text: Located | None
    """Its text, where the task holds it."""
    copied: Located | None
    """The file of the tree that it is a copy of."""
    appends: bool
    certain: bool
    """The task has no condition."""


def puts(source: Source) -> Iterator[Put]:
    """The files that the tasks or the user data put on the machine."""
    nodes = [node for node in source.once(parse, lambda: parse(source)).nodes if isinstance(node, Mapping)]
    variables = variables_of(nodes)
    for node in nodes:
        yield from puts_of(node, variables)
        files = node.sequence("write_files")
        for each in files or ():
            if isinstance(each, Mapping) and each.get("encoding") is None:
                yield from _put(each, True, variables)


def puts_of(task: Mapping, variables: dict[str, str]) -> Iterator[Put]:
    """The files that one task puts on the machine."""
    for module in modules(task):
        if isinstance(module.settings, Mapping) and module.name in _MODULES:
            items = _items(task)
            certain = task.get("when") is None and (task.get("loop") is None or items != [{}])
            for item in items:
                yield from _put(_filled(module.settings, item), certain, variables)


def _items(task: Mapping) -> list[dict[str, Scalar]]:
    """What a loop over a list of the task itself puts in the place of ``item`` and ``item.key``, round by round; one
    round with nothing where there is no such loop."""
    given = task.sequence("loop") or task.sequence("with_items")
    rounds: list[dict[str, Scalar]] = []
    for each in given or ():
        if isinstance(each, Scalar):
            rounds.append({"item": each})
        elif isinstance(each, Mapping):
            keys = {f"item.{key.value}": value for key, value in each.entries if isinstance(value, Scalar)}
            rounds.append(keys)
    return rounds or [{}]


def _filled(module: Mapping, item: dict[str, Scalar]) -> Mapping:
    """The settings of a module in one round of a loop; a value that is the item has the place of the item."""
    if not item:
        return module
    pairs = [(key, _with_item(value, item) if isinstance(value, Scalar) else value) for key, value in module.pairs]
    return replace(module, pairs=pairs)


def _with_item(value: Scalar, item: dict[str, Scalar]) -> Scalar:
    whole = _ITEM.fullmatch(value.value)
    if whole is not None:
        return item.get(whole["name"], value)
    text = _ITEM.sub(lambda match: str(item[match["name"]].value) if match["name"] in item else match[0], value.value)
    return value if text == value.value else replace(value, value=Located(text, value.value.span))


def variables_of(nodes: Iterable[Mapping]) -> dict[str, str]:
    """The texts of ``vars:`` that the file gives one value only and that need no others."""
    found: dict[str, set[str]] = {}
    for given in filter(None, (node.mapping("vars") for node in nodes)):
        for key, value in given.entries:
            text = str(value.value) if isinstance(value, Scalar) else "{{"
            found.setdefault(str(key.value), set()).add(text)
    return {name: text for name, (text, *others) in found.items() if not others and "{{" not in text}


def _path(module: Mapping, variables: dict[str, str]) -> Located | None:
    """Where the file goes, with the variables of the same file."""
    path = module.scalar("dest") or module.scalar("path")
    if path is None:
        return None
    text = _VARIABLE.sub(lambda match: variables.get(match["name"], match[0]), path.value)
    return path.value if text == path.value else Located(text, path.value.span)


def _put(module: Mapping, certain: bool, variables: dict[str, str]) -> Iterator[Put]:
    path = _path(module, variables)
    state = module.scalar("state")
    if path is None or (state is not None and state.value == "absent"):
        return
    for key, appends in _CONTENTS.items():
        text = module.scalar(key)
        if isinstance(text, Scalar):
            added = appends or module.get("append") is not None
            yield Put(path, text.value, None, added, certain)
            return
    copied = module.scalar("src")
    if copied is not None:
        yield Put(path, None, copied.value, False, certain)
