"""Chains of filters in parameter files, read as the package filters reads them: ``filter1``, ``filter2`` and so on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_PART = regex(r"(?P<chain>(?:.*\.)?)filter(?P<number>[0-9]+)\.(?P<part>name|type)\Z")
_TYPE = regex(r"[a-z][a-z0-9_]*(?:/|::)\w+\Z")


class BrokenChain(NamedTuple):
    how: str
    """``gap``, ``half``, ``name`` (not a text), ``twice`` or ``type``."""
    where: Located
    """The value, or what there is of the filter."""
    filter: str
    """``filter2``."""
    lost: tuple[str, ...]
    """The filters that are not loaded."""
    first: Located | None = None
    """The other filter of the same name."""


@dataclass(eq=False, slots=True)
class _Chain:
    parts: dict[int, dict[str, Parameter]] = field(default_factory=dict)

    @property
    def is_chain(self) -> bool:
        types = (each.get("type") for each in self.parts.values())
        return any(each is not None and _TYPE.match(str(each.value.data)) for each in types)


_Key = tuple[str, str]
"""The block, and the names before those of the filters."""


def broken_chains(params: Params) -> Iterator[BrokenChain]:
    found = _chains(params)
    files: dict[_Key, list[ParameterFile]] = {}
    for file, chains in found.items():
        for key in chains:
            files.setdefault(key, []).append(file)
    for file, chains in found.items():
        for key, chain in chains.items():
            if chain.is_chain:
                others = [each for each in files[key] if each is not file]
                yield from _broken(chain, not others or not _loaded_with(params, file, others))


def _loaded_with(params: Params, file: ParameterFile, others: list[ParameterFile]) -> bool:
    """Whether a node loads a file together with one of the others."""
    nodes = {id(load.node) for load in params.loads(file)}
    return any(id(load.node) in nodes for each in others for load in params.loads(each))


def _chains(params: Params) -> dict[ParameterFile, dict[_Key, _Chain]]:
    found: dict[ParameterFile, dict[_Key, _Chain]] = {}
    for file, parameter in params.parameters:
        match = _PART.match(parameter.name)
        if match is not None:
            chains = found.setdefault(file, {})
            chain = chains.setdefault((parameter.block.name, match["chain"]), _Chain())
            chain.parts.setdefault(int(match["number"]), {})[match["part"]] = parameter
    return found


def _broken(chain: _Chain, is_alone: bool) -> Iterator[BrokenChain]:
    """The first cause, in the order in which the chain is read. Where several files give parts of it, each alone shows
    neither what is missing nor what comes twice."""
    names: dict[str, Located] = {}
    everything = tuple(f"filter{number}" for number in sorted(chain.parts))
    for expected in range(1, len(chain.parts) + 1):
        parts = chain.parts.get(expected)
        if parts is None:
            later = sorted(number for number in chain.parts if number > expected) or sorted(chain.parts)
            first = next(iter(chain.parts[later[0]].values()))
            if is_alone:
                yield BrokenChain("gap", first.key, f"filter{expected}", tuple(f"filter{each}" for each in later))
            return
        broken = _refused(f"filter{expected}", parts, names, everything)
        if broken is not None:
            if is_alone or broken.how != "half":
                yield broken
            return


def _refused(
    name: str, parts: dict[str, Parameter], names: dict[str, Located], everything: tuple[str, ...]
) -> BrokenChain | None:
    if len(parts) == 1:
        (part,) = parts.values()
        return BrokenChain("half", part.key, name, everything)
    called, kind = parts["name"], parts["type"]
    if not isinstance(called.value.data, str):
        return BrokenChain("name", Located(called.text, called.span), name, everything)
    if called.value.data in names:
        again = Located(called.value.data, called.span)
        return BrokenChain("twice", again, name, everything, names[called.value.data])
    names[called.value.data] = Located(called.value.data, called.span)
    if str(kind.value.data).count("/") != 1:
        return BrokenChain("type", Located(kind.text, kind.span), name, everything)
    return None
