"""A Python file as libcst reads it: nodes by their offsets in the text, and imports that a change needs."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING
from typing import TypeVar

from bringup_lint.codemods.imports import Import
from bringup_lint.codemods.imports import with_import
from bringup_lint.dataclass import dataclass

if TYPE_CHECKING:
    import libcst

BOM = "\ufeff"
_Node = TypeVar("_Node", bound="libcst.CSTNode")


@dataclass
class Module:
    """A file that is being changed."""

    bom: str
    tree: libcst.Module
    offsets: dict[libcst.CSTNode, tuple[int, int]]
    """Node -> start and end of its text, in bytes after the byte order mark."""
    body: str

    def offset(self, at: int) -> int:
        """The offset in bytes of an offset in the text of the file."""
        return len(self.body[: at - len(self.bom)].encode())

    def node(self, kind: type[_Node], start: int, end: int) -> _Node | None:
        """The node of a kind with this stretch of the text."""
        wanted = (self.offset(start), self.offset(end))
        return next((each for each, place in self.offsets.items() if isinstance(each, kind) and place == wanted), None)

    def replaced(self, old: libcst.CSTNode, new: libcst.CSTNode, imports: Iterable[Import] = ()) -> str:
        """The text of the file with another node, and with the imports that it lacks."""
        import libcst

        tree = self.tree.deep_replace(old, new)
        if not isinstance(tree, libcst.Module):
            return self.bom + self.body
        code = tree.code
        for each in imports:
            code = with_import(code, each)
        return self.bom + code


def read(text: str) -> Module:
    """Parse a file; raises ``libcst.ParserSyntaxError`` for one that is not valid."""
    import libcst
    from libcst.metadata import ByteSpanPositionProvider
    from libcst.metadata import MetadataWrapper

    body = text.removeprefix(BOM)
    wrapper = MetadataWrapper(libcst.parse_module(body), unsafe_skip_copy=True)
    places = wrapper.resolve(ByteSpanPositionProvider)
    offsets = {node: (place.start, place.start + place.length) for node, place in places.items()}
    return Module(text[: len(text) - len(body)], wrapper.module, offsets, body)
