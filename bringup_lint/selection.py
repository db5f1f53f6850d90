"""Which rules run: the names of rules and families that the configuration and the command line give."""

from __future__ import annotations

from collections.abc import Collection
from collections.abc import Container
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cached_property

from bringup_lint.config import MOST_SAID
from bringup_lint.config import OFF
from bringup_lint.config import Config
from bringup_lint.config import ConfigError
from bringup_lint.discover.tree import display_name
from bringup_lint.finding import Severity
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.source import Source
from bringup_lint.spelling import meant


class Selection:
    """Which rules run: ``select`` minus ``ignore`` and what is off, each a rule id, a family, or an older name of a
    rule."""

    def __init__(self, registry: Registry, config: Config):
        self.registry = registry
        self.config = config
        self.families = {family.name for family in registry.families}
        selected = [name for name in dict.fromkeys(config.select) if name != "all"]
        listed = (name for names in config.per_file_ignores.values() for name in names)
        self._refuse_unid_of([*selected, *config.ignore, *config.severity, *listed])
        self.select = frozenset(self.id_of(name) for name in selected)
        self.ignore = frozenset(self.id_of(name) for name in config.ignore)
        self.left_out = frozenset(self.id_of(name) for name in config.left_out)
        self.levels = {self.id_of(name): level for name, level in config.severity.items()}

    def _refuse_unid_of(self, named: Iterable[str]) -> None:
        """Raises ConfigError that says all names that mean nothing."""
        unknown: list[str] = []
        for name in dict.fromkeys(named):
            try:
                self.id_of(name)
            except ConfigError as error:
                unknown.append(str(error))
        if unknown:
            raise ConfigError("\n".join(unknown[:MOST_SAID]))

    def id_of(self, name: str) -> str:
        """The id that a name means. Raises ConfigError when it means none."""
        if name in self.families or name in self.registry.family_of:
            return name
        if name in self.registry.aliases:
            return self.registry.aliases[name]
        near = meant(name, [*self.families, *self.registry.family_of])
        raise ConfigError(
            f"{self.config.place(name)}no rule or family is called '{name}'"
            + (f"; did you mean '{near}'?" if near else "")
        )

    def level(self, rule_id: str) -> str:
        """The severity that the configuration gives a rule, itself or its family; empty where it gives none."""
        if not self.levels:
            return ""
        return self.levels.get(rule_id) or self.levels.get(rule_id.partition("/")[0], "")

    def severity(self, rule_id: str) -> Severity | None:
        level = self.level(rule_id)
        return None if level in ("", OFF) else Severity[level.upper()]

    def runs(self, rule_id: str) -> bool:
        return rule_id in self.running

    @cached_property
    def running(self) -> frozenset[str]:
        """The ids of the rules that run."""
        ids = self._ids_of(self.select) if self.select else self.registry.family_of
        return frozenset(each for each in ids if not is_among(each, self.ignore) and self.level(each) != OFF)

    def _ids_of(self, selected: Collection[str]) -> Iterator[str]:
        """The rules that names of rules and families mean."""
        for family in self.registry.families:
            whole = family.name in selected
            yield from family.files if whole else [each for each in selected if each in family.files]

    def _is_selected(self, rule_id: str) -> bool:
        return not self.select or is_among(rule_id, self.select)

    def mutes(self, rule_id: str) -> bool:
        """Whether nothing but a configuration that was found in the tree keeps a rule from running."""
        if self.config.found is None or self.runs(rule_id) or is_among(rule_id, self.left_out):
            return False
        return self._is_selected(rule_id)

    def muted_by(self, rule_id: str) -> str:
        """The name by which the configuration switches off a rule that it mutes."""
        off = (name for name, level in self.config.severity.items() if level == OFF)
        return next(name for name in (*self.config.ignore, *off) if is_name_of(self.id_of(name), rule_id))

    def covers(self, name: str) -> bool:
        """Whether all that a name of a rule or family means is selected."""
        return self._is_selected(self.id_of(name))


def is_name_of(name: str, rule_id: str) -> bool:
    """Whether a name of a rule or family means the rule."""
    return name == rule_id or rule_id.startswith(name + "/")


def is_among(rule_id: str, among: Container[str]) -> bool:
    """Whether one of some names of rules and families means the rule."""
    return rule_id in among or rule_id.partition("/")[0] in among


def source_of(config: Config) -> Source:
    """The file of a configuration, for places in it."""
    return Source(display_name(str(config.path)), config.text)


def means(name: str, rule: Rule | None, rule_id: str) -> bool:
    """Whether a name of a rule or family, an older one of the rule too, means the rule."""
    return is_name_of(name, rule_id) or (rule is not None and name in rule.meta.aliases)


def should_have_silenced(name: str, rules: Mapping[str, Rule], selection: Selection) -> bool:
    """Whether it is wrong that an ignored name silenced nothing: its rules ran, or their family has no such rule. Other
    families may be a user's own, which this run does not load."""
    family = name.partition("/")[0]
    try:
        selection.id_of(name)
    except ConfigError:
        return family in selection.families
    return selection.covers(name) and any(means(name, rule, rule_id) for rule_id, rule in rules.items())
