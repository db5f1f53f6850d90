"""The texts with which a source may name parameters."""

from __future__ import annotations

from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_HOLE = regex(r"%[-+ #0-9.]*[a-zA-Z]|\{[^{}]*\}")
"""Where a formatted text takes something in."""
_JOINTS = "._/"
LOOSE = regex(
    r"automatically_declare_parameters_from_overrides|allow_undeclared_parameters|generate_parameter|registerFromPlugin"
    r"|\bimport_module\(",
    hints="automatically_declare_parameters_from_overrides allow_undeclared_parameters generate_parameter "
    "registerFromPlugin import_module",
)
"""What declares parameters that the source does not name: plugins of behaviour trees, too, find the node."""
PLAIN = regex(
    r"(?:[gs]et|has|list|describe|undeclare|on_set|add|remove)_\w{0,64}?parameter\w{0,64}"
    r"|[pP]arameter(?:Value|Descriptor|Event)?"
)
"""Functions with parameters in their names that declare none."""


class Asked(NamedTuple):
    """A parameter that is asked for under a literal name."""

    name: Located
    required: bool
    """The call raises an exception when the parameter is not declared."""
    is_quiet: bool = False
    """The call leaves a default in place then, and nothing else looks whether the parameter is there."""


@dataclass(frozen=True)
class ParameterWords:
    texts: frozenset[str] = frozenset()
    """Every text of the source but those by which parameters are only read."""
    pieces: frozenset[str] = frozenset()
    """Texts that are put together with something else."""
    asked: tuple[Asked, ...] = ()
    unset: tuple[Located, ...] = ()
    """Parameters that are declared without a default and used all the same: not given, they raise an exception."""
    open: bool = False
    """Names of parameters may come from somewhere else."""
    helpers: frozenset[str] = frozenset()
    """Functions that declare a parameter under a name that they are given."""
    handed: frozenset[str] = frozenset()
    """Functions that are given a name which is not written in the source."""
    declared: frozenset[str] | None = None
    """The names of all declarations, where each is written in its call; None where some are not."""

    def __or__(self, other: ParameterWords) -> ParameterWords:
        return ParameterWords(
            self.texts | other.texts,
            self.pieces | other.pieces,
            self.asked + other.asked,
            self.unset + other.unset,
            self.open or other.open,
            self.helpers | other.helpers,
            self.handed | other.handed,
            None if self.declared is None or other.declared is None else self.declared | other.declared,
        )

    @property
    def is_open(self) -> bool:
        """Whether names of parameters may come from elsewhere, also through a helper of another source."""
        return self.open or not self.helpers.isdisjoint(self.handed)

    def name(self, parameter: str) -> bool:
        """Whether a parameter is declared, or the texts may name it: as a whole, by its last part, or put together."""
        if self.declared is not None:
            return parameter in self.declared
        leaf = parameter.rpartition(".")[2]
        if parameter in self.texts or leaf in self._leaves:
            return True
        return any(_is_part(piece, parameter) for piece in self.joined)

    @cached_property
    def _leaves(self) -> frozenset[str]:
        return frozenset(text.rpartition(".")[2] for text in self.texts)

    @cached_property
    def joined(self) -> frozenset[str]:
        found = {piece for piece in self.pieces if len(piece) > 1}
        for text in self.texts:
            if len(text) > 1 and (text[0] in _JOINTS or text[-1] in _JOINTS):
                found.add(text)
            parts = _HOLE.split(text)
            if len(parts) > 1:
                found.update(part for part in parts if len(part) > 1)
        return frozenset(piece for piece in found if not piece.isspace())


def _is_part(piece: str, name: str) -> bool:
    return name.startswith(piece) or name.endswith(piece) or f".{piece}" in name
