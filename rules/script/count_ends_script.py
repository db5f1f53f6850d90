"""Under `set -e` counting from 0 ends the script.

## What it finds
`((NAME++))`, `((NAME--))` and `let NAME++` as a statement in a bash script under `set -e`, where the script sets NAME
to 0 and to nothing else.

Silent before `&&` and `||`, in conditions, in functions that are called there, and where anything else changes NAME.

## Why it matters on a robot
`((NAME++))` has the value that NAME had before. 0 counts as a failure, so that `set -e` ends the script at the first
count, without a message: a health check stops at the first problem that it finds, an installer in the middle.

## Bad
```sh
set -e
errors=0
ping -c 1 lidar || ((errors++))
echo "$errors errors"
```

## Good
```sh
set -e
errors=0
ping -c 1 lidar || errors=$((errors + 1))
echo "$errors errors"
```

## When to ignore it
Never.

## References
- bash(1), "Compound Commands": ((expression))
- https://mywiki.wooledge.org/BashFAQ/105
"""

from collections import Counter
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import ended_by_failure
from bringup_lint.api.shell import shell_commands

COUNTS = regex(r"\s*(?P<name>[A-Za-z_]\w*)\s*(?:\+\+|--)\s*")
HAS_COUNT = regex(r"(?:\(\(|\blet)\s*(?:[\"']\s*)?[A-Za-z_]\w*\s*(?:\+\+|--)")
CHANGES = (
    regex(r"(?<![\w$])(?P<name>[A-Za-z_]\w*)\s*[-+*/%]?=(?!=)"),
    regex(r"(?:\+\+|--)[ \t]*(?P<name>[A-Za-z_]\w*)"),
    regex(r"\$\(\(\s*(?P<name>[A-Za-z_]\w*)\s*(?:\+\+|--)"),
)
READS = regex(r"\b(?:for|select|read|getopts|mapfile|readarray|printf\s+-v|eval)\b([^\n;]*)")
WORD = regex(r"\w+")
ZERO = regex(r"(?P<name>[A-Za-z_]\w*)=0?")
DECLARES = ("local", "declare", "typeset", "export", "readonly")
OTHER_SHELL = regex(r"#![^\n]*\b(?:sh|dash|ash|zsh|ksh)\b")


@rule("error", silent="bash ends the script at the count without a word")
def count_ends_script(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and source.matches(HAS_COUNT) and not OTHER_SHELL.match(source.text):
            yield from _of(source)


def _of(source: Source) -> Iterator[Finding]:
    zeros: dict[str, list[Located]] = {}
    for command in shell_commands(source):
        for word in (*command.assignments, *(command.words[1:] if command.name in DECLARES else ())):
            if found := ZERO.fullmatch(word):
                zeros.setdefault(found["name"], []).append(word)
    said = set()
    changes: Counter[str] = Counter()
    for statement in ended_by_failure(source):
        where = _counted(statement.block)
        found = COUNTS.fullmatch(where) if where is not None else None
        if where is None or found is None or found["name"] in said or found["name"] not in zeros:
            continue
        name = found["name"]
        said.add(name)
        changes = changes or _changes(source.text)
        if changes[name] == len(zeros[name]):
            yield finding(
                where,
                f"{name} is 0 at first, so this counts as a failure: under set -e the script ends here",
                advice=f"write {name}=$(({name} {'-' if '--' in where else '+'} 1))",
                related=[note(zeros[name][0], "it begins with 0")],
            )


def _counted(block: Block) -> Located | None:
    """What a statement calculates."""
    if block.command is None:
        return block.arithmetic
    return block.command.words[1] if block.command.name == "let" and len(block.command.words) == 2 else None


def _changes(text: str) -> Counter[str]:
    """The places where each variable may get another value than by counting after its use."""
    found = Counter(match["name"] for pattern in CHANGES for match in pattern.finditer(text))
    for match in READS.finditer(text):
        found.update(set(WORD.findall(match[1])))
    return found
