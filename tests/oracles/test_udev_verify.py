"""The parser against ``udevadm verify``: the same complaints at the same lines of real and damaged rules."""

from __future__ import annotations

import os
import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from bringup_lint.graph.udev.conditions import contradict
from bringup_lint.graph.udev.conditions import own_conditions
from bringup_lint.model.udev import Rule
from bringup_lint.model.udev import RulesFile
from bringup_lint.parsers.udev import parse
from bringup_lint.parsers.udev_keys import DROPPING
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.conftest import PROJECT
from tests.oracles.answers import Oracle
from tests.oracles.udevadm import tool
from tests.oracles.udevadm import udevadm
from tests.oracles.udevadm import verify

FOLDER = Path(__file__).parent
DIFFERENCES = read_toml((FOLDER / "differences/udev.toml").read_text("utf-8"))["difference"]
SEEDS = (FOLDER / "udev/seeds.rules").read_text("utf-8").splitlines()
MUTANTS = 900

UNREADABLE = "Invalid key/value pair"
WORDS = {
    "no-operator": UNREADABLE,
    "unquoted-value": UNREADABLE,
    "single-quoted-value": UNREADABLE,
    "value-not-closed": UNREADABLE,
    "attribute-not-closed": UNREADABLE,
    "bad-escape": UNREADABLE,
    "blank-after-backslash": UNREADABLE,
    "end-of-file-in-rule": "Unexpected EOF",
    "line-too-long": "Line is too long",
    "unknown-key": "Invalid key '",
    "removed-key": "Invalid key '",
    "byte-order-mark": "Invalid key '",
    "match-only-key": "Invalid operator",
    "invalid-operator": "Invalid operator",
    "coerced-operator": "assuming '='",
    "invalid-attribute": "Invalid attribute for",
    "missing-attribute": "Invalid attribute for",
    "unexpected-attribute": "Invalid attribute for",
    "bad-test-mode": "Failed to parse mode",
    "assignment-of-any-case": "Invalid prefix 'i'",
    "any-case-not-allowed": "Invalid prefix 'i'",
    "read-only-property": "cannot be set",
    "name-without-effect": "Ignoring NAME=",
    "unknown-builtin": "Unknown builtin",
    "bad-option-value": "Failed to parse l",
    "unknown-option": "Invalid value for OPTIONS",
    "bad-substitution": "(char ",
    "substitution-without-argument": "(char ",
    "empty-value": "empty value",
    "no-effect": "The line has no effect, ignoring",
    "goto-without-label": "has no matching label",
    "goto-backward": "has no matching label",
    "second-jump": "Contains multiple",
    "label-unused": "is unused",
    "duplicate": "duplicate expressions",
    "conflict": "conflicting match expressions",
}
"""Each of our complaints, and the words in which udevadm says the same."""

FATAL = {"no-operator", "end-of-file-in-rule", "line-too-long", *DROPPING}
FATAL |= {code for code, words in WORDS.items() if words == UNREADABLE}

Complaint = tuple[int, str]
"""Last physical line of the rule, and udevadm's words for the complaint."""


def ours(name: str, text: str) -> set[Complaint]:
    file = parse(Source(name, text))
    found = set()
    for rule in file.rules:
        line = rule.source.position(max(rule.span.end - 1, rule.span.start)).line
        for code in _until_dropped(file, rule):
            found.add((line, WORDS[code]))
    return found


def _until_dropped(file: RulesFile, rule: Rule) -> Iterator[str]:
    """udev stops at the first error of a line that makes it drop the line."""
    problems = [file.problems[index] for index, owner in file.owners.items() if owner is rule]
    whole = ("end-of-file-in-rule", "line-too-long")
    for problem in sorted(problems, key=lambda one: -1 if one.code in whole else _start(one)):
        yield problem.code
        if problem.code in FATAL:
            return
    conditions = own_conditions(rule)
    pairs = [(one, other) for index, other in enumerate(conditions) for one in conditions[:index]]
    if any(contradict(one, other, one_rule=True) for one, other in pairs):
        yield "conflict"
    if any(_same(one.token, other.token) for one, other in pairs):
        yield "duplicate"


def _start(problem) -> int:
    where = problem.where
    return where.start if hasattr(where, "start") else where.span.start


def _same(one, other) -> bool:
    return (one.name, one.operator, one.value) == (other.name, other.operator, other.value)


def theirs(messages: list[str]) -> set[str]:
    found = set()
    for message in messages:
        known = [words for words in dict.fromkeys(WORDS.values()) if words in message]
        found.add("empty value" if "empty value" in message else known[0] if known else message)
    return found


def reasoned(words: str, line: str, side: str) -> str:
    """The reason in the table of differences for a complaint that only one side makes."""
    for entry in DIFFERENCES:
        if entry["side"] == side and re.search(entry["words"], words) and re.search(entry["line"], line):
            return entry["reason"]
    return ""


def said(texts: list[str], folder: Path) -> list[dict[str, list[str]]]:
    """What ``udevadm verify`` says of each file: the last line of a rule to the messages."""
    paths = [folder / f"{number:04}.rules" for number in range(len(texts))]
    for path, text in zip(paths, texts, strict=True):
        path.write_bytes(text.encode("utf-8", errors="surrogateescape"))
    found: dict[str, dict[str, list[str]]] = {str(path): {} for path in paths}
    for (path, line), messages in verify(paths).items():
        found[path][str(line)] = [message.replace(path, "FILE") for message in messages]
    return list(found.values())


def judge(pairs: list[tuple[str, dict[str, list[str]]]]) -> None:
    """Both make the same complaints at the same lines of nearly all files, but for the reasoned differences."""
    wrong = []
    for text, messages in pairs:
        mine = ours("50-robot.rules", text)
        their = {(int(line), words) for line, said in messages.items() for words in theirs(said)}
        lines = re.split(r"\r\n|[\n\r]", text)
        alone = [("ours", *one) for one in mine - their] + [("udevadm", *one) for one in their - mine]
        left = [one for one in alone if not reasoned(one[2], line_of(lines, one[1]), one[0])]
        wrong += ["; ".join(f"{item} in {line_of(lines, item[1])!r}" for item in left)] if left else []
    assert len(wrong) <= 0.01 * len(pairs), "\n".join(wrong)


def line_of(lines: list[str], number: int) -> str:
    return lines[number - 1] if number <= len(lines) else ""


def mutants(seeds: list[str], number: int) -> list[str]:
    rng = random.Random(254)
    files = []
    for _ in range(number):
        lines = rng.sample(seeds, 3)
        at = rng.randrange(3)
        for _ in range(rng.choice((1, 1, 1, 2))):
            lines[at] = damaged(lines[at], rng)
        files.append("\n".join(lines) + rng.choice(("\n", "\n", "\r\n", "")))
    return files


def damaged(line: str, rng: random.Random) -> str:
    place = rng.randrange(len(line) + 1)
    kind = rng.randrange(12)
    if kind == 0:
        return line[:place] + line[place + 1 :]
    if kind == 1:
        return line[:place] + rng.choice("\"'{}=+-:!,\\ $%#|*abEi\t") + line[place:]
    if kind == 2:
        found = rng.choice(list(re.finditer(r"==|!=|\+=|-=|:=|=|\Z", line)))
        return line[: found.start()] + rng.choice(("==", "!=", "+=", "-=", ":=", "=")) + line[found.end() :]
    if kind == 3:
        found = rng.choice(list(re.finditer(r"[A-Z]{3,}", line)) or list(re.finditer(r"\Z", line)))
        key = rng.choice((found[0].lower(), found[0][:-1], found[0] + "S", "ATTR", "TAGS", "BUS", "RESULT", "TEST"))
        return line[: found.start()] + key + line[found.end() :]
    if kind == 4:
        return re.sub(r'"([^"]*)"', rng.choice(("'\\1'", "\\1", 'e"\\1"', 'i"\\1"', 'ei"\\1"', '"\\1')), line, count=1)
    if kind == 5:
        return re.sub(r"\{[^}]*\}", rng.choice(("", "{}", "{x", "{builtin}", "{0666}")), line, count=1)
    if kind == 6:
        return line + rng.choice((" \\", "\\", " \\ ", ", \\\n# comment\n" + 'TAG+="x"', ",", '"', " # trailing"))
    if kind == 7:
        return rng.choice(("\ufeff", " ", ",", "\\\n", "\t")) + line
    if kind == 8:
        value = rng.choice(
            ("%q", "$foo", "%s", "$env", "%k", "$$", "%%", "", "a|b", "\\x41", '\\"', "%c{2+}", "$attr{x")
        )
        return re.sub(r'"[^"]*"$', lambda _: f'"{value}"', line)
    if kind == 9:
        tokens = line.split(", ")
        return ", ".join([*tokens, rng.choice(tokens)])
    if kind == 10:
        return line.replace(", ", rng.choice((",", " ", " , ", ",,", "")), 1)
    return line[:place]


def test_damaged_rules(answers: Oracle, tmp_path: Path) -> None:
    texts = mutants(SEEDS, MUTANTS)
    judge(answers.of("udev/rules", tool(), texts, lambda texts: said(texts, tmp_path)).pairs)


def real_files() -> list[str]:
    folders = [PROJECT / "fixtures/udev", Path("/usr/lib/udev/rules.d")]
    folders += [Path(name) for name in [os.environ.get("BRINGUP_LINT_CORPUS", "")] if name]
    paths = [path for folder in folders for path in sorted(folder.rglob("*.rules")) if path.is_file()]
    return [path.read_bytes().decode(errors="surrogateescape") for path in paths]


@pytest.mark.skipif(udevadm() is None, reason="needs udevadm of systemd 254 or newer")
def test_real_rules(tmp_path: Path) -> None:
    texts = [text for text in real_files() if text and "@SERIAL@" not in text]
    judge(list(zip(texts, said(texts, tmp_path), strict=True)))
