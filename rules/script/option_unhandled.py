"""The options that `getopts` takes and the branches for them do not agree.

## What it finds
In a loop `while getopts STRING NAME` whose `case $NAME in` is all that looks at NAME:

- a letter of STRING for which there is no branch, also no `*`;
- a letter of a branch that is not in STRING, beside one of STRING that has no branch;
- `$OPTARG`, without a default, in the branch of a letter without a colon in STRING.

## Why it matters on a robot
The script accepts the option and does as if it were not there: `-p 7126` still talks to the usual port, `-d can1` sets
up another interface, and no message says so.

## Bad
```sh
while getopts "d:b:h" option; do
    case $option in
        d) device=$OPTARG ;;
        r) bitrate=$OPTARG ;;
        h) usage ;;
    esac
done
```

## Good
```sh
while getopts "d:b:h" option; do
    case $option in
        d) device=$OPTARG ;;
        b) bitrate=$OPTARG ;;
        h) usage ;;
    esac
done
```

## When to ignore it
When an option is accepted for the sake of old callers: give it a branch that does nothing.

## References
- POSIX, getopts(1)
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import shell_blocks

LETTERS = regex(r":?(?:[A-Za-z0-9]:?)+")
LETTER = regex(r"[A-Za-z0-9]")
CATCHES_ALL = regex(r"[*?\[].*")
"""A pattern, without quotes or a backslash, that fits other letters, too."""
MOST = 200
"""Branches, and uses of the option, that are looked at."""
ARGUMENT = regex(r"\$\{?OPTARG\b(?!:?[-+=?])")


@rule("warning", silent="getopts accepts the option, and nothing looks at it")
def option_unhandled(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and source.text.count("getopts") == 1:
            for loop in _loops(shell_blocks(source)):
                yield from _of(loop)


def _loops(blocks: tuple[Block, ...]) -> Iterator[Block]:
    for block in blocks:
        if block.kind == "loop" and block.condition and (command := block.condition[0].command) is not None:
            if command.name == "getopts" and len(command.words) > 2:
                yield block
        for body in block.bodies:
            yield from _loops(body)


def _of(loop: Block) -> Iterator[Finding]:
    command = loop.condition[0].command
    assert command is not None
    letters, name = command.words[1], command.words[2]
    cases = [block for block in loop.bodies[0] if block.kind == "branches" and block.items]
    if not LETTERS.fullmatch(letters) or len(cases) != 1 or not _is_only_one(cases[0], name):
        return
    accepted = set(LETTER.findall(letters))
    labels = {label: pattern for pattern in cases[0].items for label in _labels(pattern)}
    unknown = [labels[each] for each in labels if LETTER.fullmatch(each) and each not in accepted]
    for letter in dict.fromkeys(LETTER.findall(letters)):
        if letter not in labels and (unknown or not any(map(CATCHES_ALL.fullmatch, labels))):
            at = letters.index(letter)
            yield finding(
                letters.part(at, at + 1),
                f"-{letter} is accepted, and no branch is for it: the option has no effect",
                advice=f"write a branch {letter})",
                related=[note(each, "no option of getopts") for each in unknown],
            )
    for pattern, body in zip(cases[0].items, cases[0].bodies):
        taken = [each for each in _labels(pattern) if each in accepted and f"{each}:" not in letters]
        use = next(_arguments(body), None)
        if taken and use is not None and len(taken) == len(_labels(pattern)):
            yield finding(
                use,
                f"-{taken[0]} takes no argument: OPTARG is empty here",
                advice=f"write {taken[0]}: in the string of getopts",
                related=[note(letters, "no colon follows the letter")],
            )


def _is_only_one(case: Block, name: Located) -> bool:
    """Whether a case asks for the option, and nothing else does."""
    text = name.span.source.text
    uses = list(re.finditer(rf"\$(?:{re.escape(name)}\b|\{{{re.escape(name)}\b)", text))
    first = case.items[0].span.start
    asks = re.compile(r"\}?[\"']?\s+in(?:\s|#[^\n]*\n|\()*[^\n]{0,40}")
    before = [use for use in uses if use.end() < first]
    is_short = len(uses) <= MOST and len(case.items) <= MOST
    is_asked = is_short and bool(before) and asks.fullmatch(text, before[-1].end(), first) is not None
    return is_asked and all("case" in text[use.start() - 8 : use.start()] or _is_said(text, use) for use in uses)


def _is_said(text: str, use: re.Match[str]) -> bool:
    """Whether a message names the option."""
    line = text[text.rfind("\n", 0, use.start()) + 1 : use.start()]
    return re.search(r"\b(?:echo|printf)\b[^;|]*\Z", line) is not None


def _labels(pattern: Located) -> list[str]:
    """All patterns of a branch as they are written, of which its place is that of the last."""
    before = pattern.span.source.line_before(pattern.span.start)
    others = before.rpartition(";;")[2].replace("(", " ").split("|")[:-1]
    raw = (each.strip() for each in (pattern.span.text, *others))
    return [each[1:-1] if LETTER.fullmatch(each[1:-1]) else each for each in raw]


def _arguments(blocks: tuple[Block, ...]) -> Iterator[Located]:
    for block in blocks:
        command = block.command
        if command is not None:
            for word in (*command.assignments, *command.words):
                if found := ARGUMENT.search(word):
                    yield word.part(*found.span())
        for body in block.bodies:
            yield from _arguments(body)
