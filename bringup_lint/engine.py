"""The run: choose rules, run them, suppress, sort. The engine names no rule but the ones that speak of itself."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Container
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cached_property

from bringup_lint import budget
from bringup_lint.apart import Steps
from bringup_lint.apart import failing
from bringup_lint.config import MOST_SAID
from bringup_lint.config import OFF
from bringup_lint.config import Config
from bringup_lint.config import ConfigError
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import replace
from bringup_lint.discover.tree import display_name
from bringup_lint.finding import Applicability
from bringup_lint.finding import Confidence
from bringup_lint.finding import Finding
from bringup_lint.finding import Fix
from bringup_lint.finding import Severity
from bringup_lint.finding import Suppression
from bringup_lint.finding import changed
from bringup_lint.finding.copies import merged
from bringup_lint.isolation import check
from bringup_lint.isolation import too_slow
from bringup_lint.isolation import unread
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from bringup_lint.robot import OF_SYNTAX
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from bringup_lint.spelling import meant
from bringup_lint.suppress import UNUSED
from bringup_lint.suppress import Ignores
from bringup_lint.suppress import ignores_in
from bringup_lint.suppress.files import file_ignores


@dataclass(frozen=True)
class Outcome:
    """What a run found."""

    findings: tuple[Finding, ...]
    """Sorted by place; suppressed ones carry their suppression."""
    rules: dict[str, Rule]
    """The rules that ran, by id."""
    failures: tuple[str, ...]
    """What failed inside, one line each."""
    hidden: dict[Severity, int]
    """How many findings of each severity lie below the lowest severity shown."""
    unsaid: frozenset[str] = frozenset()
    """The rules that were not asked for."""
    quiet: frozenset[tuple[str, str]] = frozenset()
    """Rules and files of the findings below the lowest severity shown."""
    elsewhere: int = 0
    """How many findings are left out because the change that is judged has no part in them."""


class Selection:
    """Which rules run: ``select`` minus ``ignore`` and what is off, each a rule id, a family, or an older name of a
    rule."""

    def __init__(self, registry: Registry, config: Config):
        self.registry = registry
        self.config = config
        self.families = {family.name for family in registry.families}
        selected = [name for name in dict.fromkeys(config.select) if name != "all"]
        listed = (name for names in config.per_file_ignores.values() for name in names)
        self._refuse_unknown([*selected, *config.ignore, *config.severity, *listed])
        self.select = frozenset(self.known(name) for name in selected)
        self.ignore = frozenset(self.known(name) for name in config.ignore)
        self.left_out = frozenset(self.known(name) for name in config.left_out)
        self.levels = {self.known(name): level for name, level in config.severity.items()}

    def _refuse_unknown(self, named: Iterable[str]) -> None:
        """Raises ConfigError that says all names that mean nothing."""
        unknown: list[str] = []
        for name in dict.fromkeys(named):
            try:
                self.known(name)
            except ConfigError as error:
                unknown.append(str(error))
        if unknown:
            raise ConfigError("\n".join(unknown[:MOST_SAID]))

    def known(self, name: str) -> str:
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
        return frozenset(each for each in ids if not named(each, self.ignore) and self.level(each) != OFF)

    def _ids_of(self, meant: Collection[str]) -> Iterator[str]:
        """The rules that names of rules and families mean."""
        for family in self.registry.families:
            yield from family.files if family.name in meant else [each for each in meant if each in family.files]

    def _is_selected(self, rule_id: str) -> bool:
        return not self.select or named(rule_id, self.select)

    def mutes(self, rule_id: str) -> bool:
        """Whether nothing but a configuration that was found in the tree keeps a rule from running."""
        if self.config.found is None or self.runs(rule_id) or named(rule_id, self.left_out):
            return False
        return self._is_selected(rule_id)

    def muted_by(self, rule_id: str) -> str:
        """The name by which the configuration switches off a rule that it mutes."""
        off = (name for name, level in self.config.severity.items() if level == OFF)
        return next(name for name in (*self.config.ignore, *off) if names(self.known(name), rule_id))

    def covers(self, name: str) -> bool:
        """Whether all that a name of a rule or family means is selected."""
        return self._is_selected(self.known(name))


SUPPRESSING, COMMENTS = "suppressing", "reading the comments"


def names(name: str, rule_id: str) -> bool:
    """Whether a name of a rule or family means the rule."""
    return name == rule_id or rule_id.startswith(name + "/")


def named(rule_id: str, among: Container[str]) -> bool:
    """Whether one of some names of rules and families means the rule."""
    return rule_id in among or rule_id.partition("/")[0] in among


def run(
    robot: Robot,
    registry: Registry,
    config: Config,
    *,
    ignores: bool = True,
    between: Callable[[], None] = lambda: None,
) -> Outcome:
    """Run the selected rules over a robot. Raises ConfigError for names that mean nothing, RuleError for a bad rule,
    and what ``between`` raises, which is called between the rules to end a run that nobody waits for."""
    selection = Selection(registry, config)
    asked = registry.ids_for(robot)
    rules = {rule_id: registry[rule_id] for rule_id in asked if selection.runs(rule_id)}
    muted = {rule_id: registry[rule_id] for rule_id in asked if selection.mutes(rule_id)}
    if not ignores:
        rules, muted = {**rules, **muted}, {}
    checked = check(_in_order(rules.values(), robot), robot, registry.purposes, between)
    failures = [*checked.failures, *unread(robot)]
    steps = Steps()
    judged = steps.each(
        checked.findings, "asking what reads its file", lambda found: _in_test_data(found, robot, registry)
    )
    findings = [*judged, *failures]
    findings += [too_slow(source, "Not judged: to parse it", budget.FILE) for source in robot.unfinished]
    if ignores:
        findings = _suppressed(findings, robot, rules, selection, config, steps)
    if muted:
        findings += _muted(check(muted.values(), robot, registry.purposes, between).findings, selection, config)
        rules.update(muted)
    graded = list(
        steps.each(findings, "grading", lambda found: _graded(found, rules.get(found.rule), selection)),
    )
    unique = list(_unique(sorted(graded, key=_order)))
    lowest = Severity[config.min_severity.upper()]
    shown, hidden = [], Counter[Severity]()
    quiet: set[tuple[str, str]] = set()
    for found in (*steps.attempt("looking for copies", lambda: list(merged(unique)), unique), *steps.unplaced):
        if found.severity >= lowest or found.rule in selection.select:
            shown.append(found)
        else:
            hidden[found.severity] += 1
            quiet.add((found.rule, found.source.name))
    unsaid = frozenset(registry.family_of.keys() - selection.running)
    said = dict.fromkeys(failure.message for failure in (*failures, *steps.failures))
    return Outcome(tuple(shown), rules, tuple(said), hidden, unsaid, frozenset(quiet))


def _in_order(rules: Iterable[Rule], robot: Robot) -> Iterator[Rule]:
    """The rules that may ask for the syntax of nodes, then the others, for which it need not be kept."""
    others: list[Rule] = []
    for rule in rules:
        if rule.asks is None or rule.asks & OF_SYNTAX:
            yield rule
        else:
            others.append(rule)
    robot.let_go_of_syntax()
    yield from others


def _muted(findings: Iterable[Finding], selection: Selection, config: Config) -> Iterator[Finding]:
    """What rules found that a configuration switches off: it is counted, so that nobody silences it unseen."""
    source = Source(display_name(str(config.path)), config.text)
    for found in findings:
        if selection.mutes(found.rule):
            name = selection.muted_by(found.rule)
            start = max(config.text.find(name), 0)
            where, reason = source.span(start, start + len(name)), f"'{name}' is switched off in {source.basename}"
            yield changed(found, suppression=Suppression(where, reason, external=True))


def _in_test_data(found: Finding, robot: Robot, registry: Registry) -> Finding:
    """The finding, lowered where its place is what tests read: that is often wrong on purpose, and on no robot."""
    lowered = registry.in_test_data(found.rule)
    if lowered is None or not robot.files.is_test_data(found.span):
        return found
    return changed(found, own_severity=min(found.own_severity or lowered, lowered))


def _suppressed(
    findings: Iterable[Finding],
    robot: Robot,
    rules: Mapping[str, Rule],
    selection: Selection,
    config: Config,
    steps: Steps,
) -> list[Finding]:
    """The findings with what comments and configuration say of them, and what there is to say of these."""

    def is_name_of(name: str, rule_id: str) -> bool:
        return _means(name, rules.get(rule_id), rule_id)

    def ran(name: str) -> bool:
        return _counts(name, rules, selection)

    findings = list(findings)
    comments = _comments(_with_modules(robot.sources, findings), is_name_of, steps)
    files = file_ignores(config.per_file_ignores, Source(display_name(str(config.path)), config.text), is_name_of)

    def silenced(found: Finding) -> Finding:
        return files.apply(comments.apply(found))

    applied = list(steps.each(findings, SUPPRESSING, silenced))
    complaints: list[Finding] = steps.attempt(COMMENTS, lambda: list(comments.complaints(ran)), [])
    applied += steps.each((found for found in complaints if found.rule in rules), SUPPRESSING, silenced)
    if config.per_file_ignores and UNUSED in rules:
        applied += steps.attempt(COMMENTS, lambda: list(files.complaints(robot.tree.paths, robot.sources, ran)), [])
    return applied


def _with_modules(sources: list[Source], findings: Iterable[Finding]) -> list[Source]:
    """The sources, and those that were only read for another one, such as a module that a node imports, in which
    something was found."""
    known = {id(source) for source in sources}
    return [*sources, *{id(each.source): each.source for each in findings if id(each.source) not in known}.values()]


def _comments(sources: list[Source], is_name_of: Callable[[str, str], bool], steps: Steps) -> Ignores:
    """The suppression comments of the sources of which they can be read."""
    try:
        return ignores_in(sources, is_name_of)
    except Exception:
        broken = {id(source): error for source, error in failing(sources, lambda part: ignores_in(part, is_name_of))}
        for source in sources:
            if id(source) in broken:
                steps.lost(Source(source.name), f"{COMMENTS} in {source.name}", broken[id(source)])
        return ignores_in([source for source in sources if id(source) not in broken], is_name_of)


def _graded(found: Finding, rule: Rule | None, selection: Selection) -> Finding:
    own = rule.severity if rule else Severity.ERROR
    highest = rule.meta.confidence if rule else Confidence.HIGH
    return changed(
        found,
        severity=selection.severity(found.rule) or found.own_severity or own,
        confidence=min(found.own_confidence or highest, highest),
        fix=_as_safe_as(rule, found.fix),
    )


def _as_safe_as(rule: Rule | None, fix: Fix | None) -> Fix | None:
    """The fix, unsafe unless the rule says that its fixes are safe, and where it changes more places than it names."""
    from bringup_lint.parsers.repeated_values import changes_repeated_values

    if fix is None or rule is None or (rule.meta.fix == "safe" and not changes_repeated_values(fix)):
        return fix
    return replace(fix, applicability=Applicability.UNSAFE)


def _means(name: str, rule: Rule | None, rule_id: str) -> bool:
    return names(name, rule_id) or (rule is not None and name in rule.meta.aliases)


def _counts(name: str, rules: Mapping[str, Rule], selection: Selection) -> bool:
    """Whether it is wrong that an ignored name silenced nothing: its rules ran, or their family has no such rule. Other
    families may be a user's own, which this run does not load."""
    family = name.partition("/")[0]
    try:
        selection.known(name)
    except ConfigError:
        return family in selection.families
    return selection.covers(name) and any(_means(name, rule, rule_id) for rule_id, rule in rules.items())


def _order(found: Finding) -> tuple[str, int, int, str, str]:
    return (found.span.path, found.span.start, found.span.end, found.rule, found.message)


def _unique(findings: Iterable[Finding]) -> Iterator[Finding]:
    seen = set()
    for found in findings:
        key = _order(found)
        if key not in seen:
            seen.add(key)
            yield found
