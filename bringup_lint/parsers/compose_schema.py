"""Compose files compared with the schema of the compose specification: what docker compose refuses."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cache

from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Fault
from bringup_lint.model.schema import Item
from bringup_lint.model.schema import Remark
from bringup_lint.model.yaml_node import Alias
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.model.yaml_node import YamlFile
from bringup_lint.parsers.compose_values import bad_substitutions
from bringup_lint.parsers.compose_values import fault
from bringup_lint.parsers.compose_values import number_fault
from bringup_lint.pattern import regex
from bringup_lint.schema.shapes import Shape
from bringup_lint.schema.shapes import shape
from bringup_lint.schema.table import Schema
from bringup_lint.schema.table import load
from bringup_lint.schema.walk import level
from bringup_lint.schema.walk import missing
from bringup_lint.source import Located

ROOT = "{root}"
_NAMES = {"name": regex(r"[a-zA-Z0-9._-]+"), "lower": regex(r"[a-z]+"), "*": regex(r"(?s).*")}
_INTEGER = regex(r"[-+]?(?:0b[01_]+|0o?[0-7_]+|0x[0-9a-fA-F_]+|[0-9][0-9_]*)")
_NUMBER = regex(r"[-+]?(?:\.[0-9]+|[0-9][0-9_]*(?:\.[0-9_]*)?)(?:[eE][-+]?[0-9]+)?")
_INFINITE = regex(r"[-+]?\.(?:inf|Inf|INF)|\.(?:nan|NaN|NAN)")
_TRUTHS = frozenset("true True TRUE false False FALSE".split())
_NULLS = frozenset(("", "~", "null", "Null", "NULL"))
_LEFT_OUT = ("!reset", "!override")
"""Tags of values that replace those of another file; what !reset holds does not count."""
_WORDS = {"null": "nothing", "number": "a number", "integer": "a whole number", "boolean": "true or false"}


@cache
def schema() -> Schema:
    """Each kind of mapping is a structure: ``{root}``, ``{service}``, ``{build}``, ..."""
    return load("docker/compose")


def known_keys(kind: str) -> frozenset[str]:
    """The keys of a kind of mapping, such as ``service``."""
    return frozenset(schema().items[f"{{{kind}}}"].children)


def homes_of(key: str) -> list[str]:
    """The kinds of mapping that have a key, in words."""
    kinds = schema().top.children.items()
    return [name.strip("{}").replace("_", " ") for name, item in kinds if key in item.children]


def remarks(yaml: YamlFile) -> Iterator[Remark]:
    """What docker compose has against a file that is valid YAML."""
    root = yaml.root
    if not isinstance(root, Mapping):
        return
    top = schema().items[ROOT]
    yield from _mapping(root, top)
    yield from _substitutions(yaml)


def _mapping(node: Mapping, inside: Item) -> Iterator[Remark]:
    written = [(key.value, (key, value)) for key, value in node.merged if not _is_extension(key, inside)]
    found = level(written, inside.children, inside)
    yield from (each for each in found.remarks if "*" not in inside.children or each.code != Code.UNKNOWN)
    for needed in missing(inside.children, found.known):
        yield Remark(Code.MISSING, node.span, needed.name, item=needed)
    for (key, value), item in found.known:
        yield from _value(value, shape(item.type), item, key.value)


def _is_extension(key: Scalar, inside: Item) -> bool:
    return key.value.startswith("x-") and "x-*" in inside.children


def _value(node: Node, wanted: Shape, item: Item, key: Located) -> Iterator[Remark]:
    if isinstance(node, Alias) or wanted.anything or node.tag == "!reset":
        return
    if isinstance(node, Mapping):
        yield from _in_mapping(node, wanted, item, key)
    elif isinstance(node, Sequence):
        if wanted.items is None:
            yield _wrong(node, wanted, item, key)
            return
        for each in node:
            yield from _value(each, wanted.items, item, key)
    elif isinstance(node, Scalar):
        yield from _scalar(node, wanted, item, key)


def _in_mapping(node: Mapping, wanted: Shape, item: Item, key: Located) -> Iterator[Remark]:
    if wanted.structure:
        yield from _mapping(node, schema().items[wanted.structure])
    elif wanted.values is None:
        yield _wrong(node, wanted, item, key)
    else:
        for name, value in node.merged:
            fits = bool(_NAMES[wanted.names].fullmatch(name.value))
            if not fits and wanted.names == "lower":
                continue
            if not fits:
                yield Remark(Code.NAME, name.value, "is not a name", item=item)
            yield from _value(value, wanted.values, item, name.value)


def _scalar(node: Scalar, wanted: Shape, item: Item, key: Located) -> Iterator[Remark]:
    kinds = kinds_of(node)
    if not kinds & wanted.scalars and not ("$" in node.value and wanted.scalars - {"null"}):
        yield _wrong(node, wanted, item, key)
        return
    found = number_fault(item, _number(node)) if "number" in kinds else None
    if "string" in kinds or ("number" in kinds and item.row["grammar"] == "port"):
        found = fault(item, node.value)
    if found is not None:
        yield _remark(found, node.value, item)


def _remark(found: Fault, value: Located, item: Item) -> Remark:
    return Remark(found.code, value, found.detail, found.fatal, item)


def kinds_of(node: Scalar) -> frozenset[str]:
    """What a scalar is in YAML 1.2, as the words of the schema say it: an integer is a number too."""
    text = str(node.value)
    if node.style or node.tag.endswith((":str", "!")) or node.tag in _LEFT_OUT:
        return frozenset({"string"})
    if text in _NULLS:
        return frozenset({"null"})
    if text in _TRUTHS:
        return frozenset({"boolean"})
    if _INTEGER.fullmatch(text):
        return frozenset({"integer", "number"})
    if _NUMBER.fullmatch(text) or _INFINITE.fullmatch(text):
        return frozenset({"integer", "number"} if _is_whole(text) else {"number"})
    return frozenset({"string"})


def _is_whole(text: str) -> bool:
    number = _plain(text)
    return math.isfinite(number) and number == int(number)


def _number(node: Scalar) -> float:
    return _plain(str(node.value))


def _plain(text: str) -> float:
    try:
        return float(text.replace("_", ""))
    except ValueError:
        return math.nan


def _wrong(node: Node, wanted: Shape, item: Item, key: Located) -> Remark:
    if not isinstance(node, Scalar) or not node.value:
        return Remark(Code.SHAPE, key, expected(wanted), item=item)
    code = Code.UNQUOTED if "string" in wanted.scalars else Code.SHAPE
    return Remark(code, node.value, expected(wanted), item=item)


def expected(wanted: Shape) -> str:
    """What may be at a place, for people."""
    words = []
    if "string" in wanted.scalars:
        words.append("a string")
    elif wanted.scalars - {"null"}:
        words += [_WORDS[kind] for kind in sorted(wanted.scalars - {"null"})]
    if wanted.items is not None:
        words.append("a list")
    if wanted.structure or wanted.names:
        words.append("a mapping")
    return " or ".join(words)


def _substitutions(yaml: YamlFile) -> Iterator[Remark]:
    for node in yaml.nodes:
        if isinstance(node, Scalar) and "${" in node.value:
            for bad in bad_substitutions(node.value):
                yield Remark(Code.EXPANSION, bad, "cannot be read as ${NAME} or ${NAME:-default}")
