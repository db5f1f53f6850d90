"""From a line of a log to the rules that explain it.

A rule knows log lines (``symptoms``), where ``*`` stands for any text. The rules are ranked by how much of a known line
is repeated, rare words counting more than frequent ones, and by the program that writes the line.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence
from functools import cache
from math import log

from bringup_lint.dataclass import dataclass
from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.registry import Rule

LONGEST = 2_000
"""Characters of a line that are read."""
MOST = 8
"""Rules that are named for one line."""
_NEAR = 0.6
"""Share of the best score below which a rule is not named; also of a symptom's words that a line must repeat."""
_TELLING = 4
"""Words of a symptom, frequent ones left out, from which on a line may repeat it in part: fewer, such as those of
"Parameter not set", are in lines of any program."""
_LONGER = 3
"""Times the length of a symptom from which on a line says much else."""
_LATER = 0.97
"""What a symptom counts, compared with the one before it: the first is the one by which most people meet the defect."""
_LAST = 4
"""The place from which on symptoms count the same: who knows many lines knows the last ones as well."""
_OWN, _OTHER = 1.4, 0.4
"""What a symptom counts if its family knows the program that writes the line, or only another program."""
_MOST_NAMED = 0.02
"""What the words that a line and a rule's name share add to the score, at most: less than a symptom's place."""
_COLOUR = regex(r"(?:\x1b|#033|\^\[)\[[0-9;]*[A-Za-z]")
"""How a terminal, syslog and ``cat -v`` write a colour."""
_WORD = regex(r"[a-z0-9_./=-]{2,}")
_FREQUENT = frozenset(
    "no such the and for with was not has been from this that are error failed failure warning info to of in on at "
    "is it by service unit node process systemd ros2 launch start started does exist file answers".split()
)
_WEAK = 5.0
"""The score of a symptom that says nothing alone, such as "No such file or directory"."""


class Match(NamedTuple):
    """A rule, and the known line by which it was found."""

    rule: Rule
    symptom: str
    score: float


class OtherCause(NamedTuple):
    """What a line means that no rule explains."""

    configuration: str
    """What the configuration has to do with it: ``no``, ``outside`` of the tree, or ``unjudged`` by the rules."""
    reason: str
    score: float


class Answer(NamedTuple):
    """What is known of a line: rules, the best first, or another cause."""

    matches: Sequence[Match] = ()
    other: OtherCause | None = None


class Speaker(NamedTuple):
    """The program that writes a line."""

    program: str
    families: frozenset[str]


def explained(line: str, rules: Iterable[Rule]) -> Answer:
    """The rules that explain a line, or the cause that no rule knows if that fits better."""
    known = list(rules)
    weights = Weights.of(symptom for rule in known for symptom in rule.meta.symptoms)
    read = _plain(line[:LONGEST])
    speaker = speaker_of(line)
    bare = _bare(read)
    matches = _matches(bare, known, weights, speaker)
    if not matches and bare != read:
        matches = _matches(read, known, weights, speaker)
    causes = list(_other_causes(bare, weights))
    if not causes and not matches and bare != read:
        causes = list(_other_causes(read, weights))
    other = max(causes, key=lambda cause: cause.score, default=None)
    if other is not None and (not matches or other.score > matches[0].score):
        return Answer(other=other)
    return Answer(tuple(matches))


def speaker_of(line: str) -> Speaker | None:
    """The program that writes a line, if the line shows it."""
    read = line[:LONGEST]
    return next((speaker for pattern, speaker in _speakers() if pattern.search(read)), None)


@dataclass(frozen=True)
class Weights:
    """What a word says: little if many symptoms have it."""

    counts: Counter[str]
    total: int

    @classmethod
    def of(cls, symptoms: Iterable[str]) -> Weights:
        texts = {_plain(symptom) for symptom in symptoms}
        return cls(Counter(word for text in texts for word in _words(text)), len(texts))

    def weight(self, words: Iterable[str]) -> float:
        return sum(self._weight(word) for word in words)

    def _weight(self, word: str) -> float:
        rare = 1 + log((1 + self.total) / (1 + self.counts[word]))
        return rare * 0.2 if word in _FREQUENT else rare


def _matches(line: str, rules: Iterable[Rule], weights: Weights, speaker: Speaker | None) -> list[Match]:
    weakest = min(_WEAK, weights.weight(_words(line)) / 2)
    best = (_best(rule, line, weights, speaker) for rule in rules)
    found = [_named(match, line, weights) for match in best if match.score > weakest]
    found.sort(key=lambda match: (-match.score, -match.rule.severity, match.rule.id))
    return [match for match in found if match.score >= found[0].score * _NEAR][:MOST]


def _named(match: Match, line: str, weights: Weights) -> Match:
    """Of rules that know the same line, the one whose name repeats more of it counts more."""
    shared = _words(line) & frozenset(match.rule.id.partition("/")[2].split("-")) - _FREQUENT
    return match._replace(score=match.score * (1 + min(weights.weight(shared) / 1_000, _MOST_NAMED)))


@cache
def _bare(text: str) -> str:
    """What a program says without the words with which another one passes it on."""
    return next((rest for words in _introductions() if (rest := text.partition(words)[2].strip())), text)


def _other_causes(line: str, weights: Weights) -> Iterator[OtherCause]:
    for row in table("logs/other_causes"):
        pattern = _plain(row["pattern"])
        if _holds(line, pattern):
            yield OtherCause(row["configuration"], row["reason"], _score(line, pattern, weights))


def _best(rule: Rule, line: str, weights: Weights, speaker: Speaker | None) -> Match:
    def match(place: int, symptom: str) -> Match:
        known = _bare(_plain(symptom))
        heard = _OTHER if speaker is None and _is_chance(rule.family, known, line) else _heard(rule.family, speaker)
        return Match(rule, symptom, _score(line, known, weights) * heard * _LATER ** min(place, _LAST))

    matches = (match(place, symptom) for place, symptom in enumerate(rule.meta.symptoms))
    return max(matches, key=lambda match: match.score, default=Match(rule, "", 0.0))


def _heard(family: str, speaker: Speaker | None) -> float:
    if speaker is None:
        return 1.0
    if family in speaker.families:
        return _OWN
    return _OTHER if family in _spoken_for() else 1.0


def _is_chance(family: str, symptom: str, line: str) -> bool:
    """Whether one common word of a program, such as "deprecated", may be in a long line of another one by chance."""
    telling = _words(symptom) - _FREQUENT
    common = len(telling) < 2 and all(word.isalpha() for word in telling)
    return common and family in _spoken_for() and len(line) > _LONGER * len(symptom)


def _score(line: str, symptom: str, weights: Weights) -> float:
    words = _words(symptom)
    if _holds(line, symptom):
        return weights.weight(words) + len(symptom) / 100
    said = _words(line)
    if len(line) > 8 and line in symptom:
        return weights.weight(said)
    shared = words & said
    whole = weights.weight(words)
    if len(words - _FREQUENT) < _TELLING or weights.weight(shared) < whole * _NEAR:
        return 0.0
    if not all(word in line for word in words if word.startswith("/")):
        return 0.0
    return weights.weight(shared) ** 3 / whole**2 / 2


def _holds(line: str, pattern: str) -> bool:
    """Whether a line holds the parts of a pattern between its ``*``, in their order; the word at its start and a number
    at its end are whole."""
    at = _start(line, pattern)
    if at < 0:
        return False
    *parts, last = pattern.split("*")
    for part in parts:
        at = line.find(part, at)
        if at < 0:
            return False
        at += len(part)
    while (found := line.find(last, at)) >= 0:
        at = found + len(last)
        if not (last[-1:].isdigit() and line[at : at + 1].isdigit()):
            return True
    return False


def _start(line: str, pattern: str) -> int:
    """The first place where a pattern can begin, or -1: not inside of a word."""
    first = pattern.partition("*")[0]
    at = line.find(first)
    while at > 0 and first[:1].isalnum() and line[at - 1].isalnum():
        at = line.find(first, at + 1)
    return at


@cache
def _plain(text: str) -> str:
    """Without colours, the case and the quotes, which differ between versions, and with single blanks."""
    return " ".join(re.sub("[\"'`‘’“”]", "", _COLOUR.sub("", text)).lower().split())


@cache
def _words(text: str) -> frozenset[str]:
    return frozenset(word.rstrip(".") for word in _WORD.findall(text))


@cache
def _speakers() -> Sequence[tuple[re.Pattern[str], Speaker]]:
    return [
        (re.compile(row["pattern"], re.I), Speaker(row["program"], frozenset(row["families"].split())))
        for row in table("logs/speakers")
    ]


@cache
def _introductions() -> Sequence[str]:
    return [_plain(row["text"]) for row in table("logs/introductions")]


@cache
def _spoken_for() -> frozenset[str]:
    """The families that know the lines of some program."""
    return frozenset().union(*(speaker.families for _, speaker in _speakers()))
