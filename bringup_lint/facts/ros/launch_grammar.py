"""What XML and YAML launch files may hold, in each distribution."""

from __future__ import annotations

from functools import cache

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.facts import table
from bringup_lint.facts.ros import distros
from bringup_lint.named_tuple import NamedTuple


class Attribute(NamedTuple):
    type: str
    required: bool


class Child(NamedTuple):
    entity: str
    """The entity as which a child tag is read."""
    required: bool


class Count(NamedTuple):
    """How many arguments a substitution takes."""

    least: int
    most: int | None


@dataclass(eq=False, slots=True)
class Entity:
    name: str
    attributes: dict[str, Attribute] = field(default_factory=dict)
    children: dict[str, Child] = field(default_factory=dict)
    holds_actions: bool = False
    is_action: bool = False
    is_open: bool = False
    """Launch does not look at further attributes and children."""


@dataclass(eq=False, slots=True)
class Grammar:
    entities: dict[str, Entity] = field(default_factory=dict)
    substitutions: dict[str, Count] = field(default_factory=dict)

    @property
    def actions(self) -> list[str]:
        return [entity.name for entity in self.entities.values() if entity.is_action]


@cache
def grammar(distribution: str | None) -> Grammar:
    """The grammar of a distribution; what any supported one takes when it is not known which one runs."""
    order = distros.supported()
    at = order.index(distribution) if distribution in order else None
    found = Grammar()
    for row in table("ros/launch_grammar"):
        if at is None or _first(row, order) <= at <= _last(row, order):
            _add(found, row, widen=at is None)
    return found


def _first(row: dict[str, str], order: tuple[str, ...]) -> int:
    return order.index(row["since"]) if row["since"] else 0


def _last(row: dict[str, str], order: tuple[str, ...]) -> int:
    return order.index(row["until"]) if row["until"] else len(order)


def _add(found: Grammar, row: dict[str, str], *, widen: bool) -> None:
    name, kind = row["entity"], row["kind"]
    if kind == "substitution":
        least, _, most = row["type"].partition("-")
        count = Count(int(least), int(least) if "-" not in row["type"] else (int(most) if most else None))
        found.substitutions[name] = count
        return
    entity = found.entities.setdefault(name, Entity(name))
    required = row["need"] == "required"
    if kind == "action":
        entity.is_action = True
    elif kind == "open":
        entity.is_open = True
    elif kind == "actions":
        entity.holds_actions = True
    elif kind == "extends":
        _inherit(entity, found.entities.get(row["name"]))
    elif kind == "attribute":
        known = entity.attributes.get(row["name"])
        loose = widen and known is not None and known.type != row["type"]
        entity.attributes[row["name"]] = Attribute("template" if loose else row["type"], required)
    elif kind == "child":
        entity.children[row["name"]] = Child(row["type"], required)


def _inherit(entity: Entity, base: Entity | None) -> None:
    if base is not None:
        entity.attributes.update(base.attributes)
        entity.children.update(base.children)
        entity.holds_actions = entity.holds_actions or base.holds_actions
