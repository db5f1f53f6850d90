"""When a udev rule fires: the conditions of its own line and those that jumps over it leave behind."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.graph.udev.patterns import is_plain
from bringup_lint.graph.udev.patterns import matches
from bringup_lint.graph.udev.patterns import may_overlap
from bringup_lint.model.udev import PARENT_KEYS
from bringup_lint.model.udev import Rule
from bringup_lint.model.udev import Token
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.udev_labels import targets

_SINGLE_VALUED = ("ACTION", "DEVPATH", "KERNEL", "SUBSYSTEM", "DRIVER", "CONST", "ENV")
"""Keys of which a device has exactly one value, so that "not equal" and "equal" are opposites."""
_MANY_VALUED = ("TAG", "TAGS", "SYMLINK", "RESULT", "TEST", "PROGRAM", "IMPORT", "NAME", "SYSCTL")
_MOST_JUMPS = 64

_PROPERTY_OF = {
    "ID_VENDOR_ID": ("ATTRS", "idVendor"),
    "ID_USB_VENDOR_ID": ("ATTRS", "idVendor"),
    "ID_MODEL_ID": ("ATTRS", "idProduct"),
    "ID_USB_MODEL_ID": ("ATTRS", "idProduct"),
    "ID_SERIAL_SHORT": ("ATTRS", "serial"),
    "ID_USB_SERIAL_SHORT": ("ATTRS", "serial"),
    "ID_USB_INTERFACE_NUM": ("ATTRS", "bInterfaceNumber"),
}
"""Properties that the usb_id builtin copies from the attribute of a USB parent."""


class Condition(NamedTuple):
    """One match that a device must fulfil."""

    key: str
    attribute: str
    equal: bool
    patterns: tuple[str, ...]
    token: Token
    inherited: bool = False
    """Whether a jump over the rule says it, not the rule itself."""

    @property
    def subject(self) -> tuple[str, str]:
        """What is compared; a property that udev copies from an attribute counts as that attribute."""
        if self.key == "ENV" and self.attribute in _PROPERTY_OF:
            return _PROPERTY_OF[self.attribute]
        return self.key, self.attribute

    @property
    def is_plain(self) -> bool:
        return all(is_plain(pattern) for pattern in self.patterns)

    @property
    def text(self) -> str:
        """As a rule would say it: ``SUBSYSTEM=="tty"``."""
        return f'{self.token.name}{"==" if self.equal else "!="}"{self.token.value}"'

    def accepts(self, text: str) -> bool:
        found = any(matches(pattern, text) for pattern in self.patterns)
        return found == self.equal


class Conditions(NamedTuple):
    """All that must hold for a rule, and the sets of matches of which at least one must fail."""

    positive: tuple[Condition, ...]
    jumps: tuple[tuple[Condition, ...], ...]
    known: bool = True
    """False when there were too many jumps to follow."""


def own_conditions(rule: Rule) -> tuple[Condition, ...]:
    return tuple(
        _condition(token) for token in rule.tokens if token.is_match and token.key not in ("PROGRAM", "IMPORT")
    )


def _condition(token: Token, negated: bool = False, inherited: bool = False) -> Condition:
    patterns = token.alternatives
    if "i" in token.prefix:
        patterns = tuple(pattern.lower() for pattern in patterns)
    equal = (token.operator == "==") != negated
    return Condition(str(token.key), str(token.attribute or ""), equal, patterns, token, inherited)


def all_conditions(rules: Sequence[Rule]) -> Iterator[Conditions]:
    """The conditions of every rule of one file, in order."""
    jumps = targets(rules)
    landings = _landings(rules, jumps)
    active: list[tuple[int, int, tuple[Condition, ...]]] = []
    overflow = -1
    for index, rule in enumerate(rules):
        active = [jump for jump in active if jump[1] > index]
        positive = [*own_conditions(rule), *landings.get(index, ())]
        open_jumps: list[tuple[Condition, ...]] = []
        for _, end, conditions in active:
            if end <= index or rule is None:
                continue
            opposite = _opposite(conditions)
            if opposite is None:
                open_jumps.append(conditions)
            else:
                positive.append(opposite)
        yield Conditions(tuple(positive), tuple(open_jumps), index > overflow)
        if index in jumps:
            target = jumps[index]
            end = min([target, *(jump[0] for jump in active)])
            if len(active) < _MOST_JUMPS:
                active.append((target, end, _jump_conditions(rule)))
            else:
                overflow = max(overflow, target)


def _landings(rules: Sequence[Rule], jumps: dict[int, int]) -> dict[int, tuple[Condition, ...]]:
    """What holds for the rules that only one jump reaches: those between the label of that jump and the label of a
    jump without conditions above."""
    sources: dict[int, list[int]] = {}
    for start, target in jumps.items():
        sources.setdefault(target, []).append(start)
    found: dict[int, tuple[Condition, ...]] = {}
    for start, end in jumps.items():
        if _jump_conditions(rules[start]):
            continue
        labels = sorted(target for target in sources if start < target < end)
        if not labels or len(sources[labels[0]]) != 1:
            continue
        known = tuple(one._replace(inherited=True) for one in own_conditions(rules[sources[labels[0]][0]]))
        last = labels[1] if len(labels) > 1 else end
        found.update(dict.fromkeys(range(labels[0], last), known))
    return found


def _jump_conditions(rule: Rule) -> tuple[Condition, ...]:
    """The matches of a line with GOTO, and the programs on whose success the jump depends too."""
    conditions = own_conditions(rule)
    unknown = [token for token in rule.tokens if token.key in ("PROGRAM", "IMPORT")]
    return conditions + tuple(_condition(token) for token in unknown)


def _opposite(conditions: tuple[Condition, ...]) -> Condition | None:
    """What holds where a jump with one condition was not taken."""
    if len(conditions) != 1 or conditions[0].key not in _SINGLE_VALUED:
        return None
    return _condition(conditions[0].token, negated=True, inherited=True)


def contradict(one: Condition, other: Condition, *, one_rule: bool = False) -> bool:
    """Whether no device fulfils both. A parent key counts as having one value along the chain. In one rule
    its opposites exclude each other too: all parent keys of a rule speak of one device."""
    if one.subject != other.subject or one.key in _MANY_VALUED:
        return False
    if one.token.prefix or other.token.prefix or one.token.has_substitution or other.token.has_substitution:
        return False
    if one.equal and other.equal:
        return not any(may_overlap(left, right) for left in one.patterns for right in other.patterns)
    if one.equal == other.equal or (not one_rule and {one.key, other.key} & set(PARENT_KEYS)):
        return False
    positive, negative = (one, other) if one.equal else (other, one)
    return all(_excludes(negative, pattern) for pattern in positive.patterns)


def _excludes(negative: Condition, pattern: str) -> bool:
    """Whether ``!=`` rules out all texts of a pattern."""
    return pattern in negative.patterns or (is_plain(pattern) and not negative.accepts(pattern))


def implies(one: Sequence[Condition], other: Condition) -> bool:
    """Whether a device that fulfils all of ``one`` certainly fulfils ``other``."""
    return any(_narrower(condition, other) for condition in one)


def _narrower(one: Condition, other: Condition) -> bool:
    if (one.key, one.attribute) != (other.key, other.attribute):
        return False
    if one.equal == other.equal and set(one.patterns) == set(other.patterns):
        return True
    if one.equal and one.is_plain and one.key not in PARENT_KEYS + _MANY_VALUED:
        return all(other.accepts(text) for text in one.patterns)
    return False
