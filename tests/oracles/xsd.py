"""What an XML schema allows: every path of elements and attributes from a root, read with lxml."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

XS = "{http://www.w3.org/2001/XMLSchema}"
GROUPS = (f"{XS}sequence", f"{XS}all", f"{XS}choice", f"{XS}complexContent", f"{XS}extension", f"{XS}group")


class Xsd:
    def __init__(self, file: Path) -> None:
        from lxml import etree

        self.root = etree.parse(str(file)).getroot()
        self.named = {(each.tag, each.get("name")): each for each in self.root if each.get("name")}

    def paths(self, element: str, below: str = "") -> Iterator[str]:
        """The paths below a global element, its own first; a type that holds itself is entered once."""
        yield from self._element(self.named[f"{XS}element", element], below, ())

    def _element(self, node: Any, below: str, inside: tuple[Any, ...]) -> Iterator[str]:
        if node.get("ref"):
            node = self.named[f"{XS}element", local(node.get("ref"))]
        path = f"{below}/{node.get('name')}".lstrip("/")
        yield path
        kind = node.find(f"{XS}complexType")
        if kind is None and node.get("type"):
            kind = self.named.get((f"{XS}complexType", local(node.get("type"))))
        if kind is not None and kind not in inside:
            yield from self._inside(kind, path, (*inside, kind))

    def _inside(self, node: Any, path: str, inside: tuple[Any, ...]) -> Iterator[str]:
        for each in node:
            if each.tag == f"{XS}element":
                yield from self._element(each, path, inside)
            elif each.tag == f"{XS}attribute":
                yield f"{path}@{each.get('name') or each.get('ref')}"
            elif each.tag in GROUPS:
                named = {f"{XS}extension": ("complexType", "base"), f"{XS}group": ("group", "ref")}.get(each.tag)
                other = named and self.named.get((f"{XS}{named[0]}", local(each.get(named[1], ""))))
                if other is not None:
                    yield from self._inside(other, path, inside)
                yield from self._inside(each, path, inside)


def local(name: str) -> str:
    return name.rpartition(":")[2]
