"""A loop over the arguments of a script does not end.

## What it finds
`while [ $# -gt 0 ]` (also `[[ ]]`, `-ne 0`, `-n "$1"` and `"$1" != ""`) around a `case` with a branch that neither
shifts nor leaves the loop, or without a branch for all other arguments, where nothing after the `case` shifts either.
Loops that call a function of the script or another command that may end it there are not reported.

## Why it matters on a robot
With such an argument, `$#` stays the same: the script runs forever at full load, without a word. A misspelt option in a
unit or in the call of another script is enough.

## Bad
```sh
while [ $# -gt 0 ]; do
  case "$1" in
    --sim) SIM=1; shift ;;
  esac
done
```

## Good
```sh
while [ $# -gt 0 ]; do
  case "$1" in
    --sim) SIM=1; shift ;;
    *) echo "unknown argument: $1" >&2; exit 2 ;;
  esac
done
```

## When to ignore it
Never.

## References
- bash(1), "shift"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import shell_blocks

GETOPT = regex(r"\bgetopt\b[^;]{0,2000}?\beval set\b", hints="getopt")
"""getopt(1) lets no other argument through."""
TESTS = ("[", "[[", "test")
ARGUMENTS_LEFT = regex(
    r"\$(?:#|\{#\})? (?:-gt|-ne|>|!=) 0|\$\{?#\}? (?:-gt|-ne|>|!=) 0|\$\{?#\}? -ge 1|-n \$\{?1(?::-)?\}?"
    r"|\$\{?1(?::-)?\}? != "
)
"""The test asks whether an argument is left."""
STAYS = frozenset("echo printf : true [ [[ test export local declare readonly typeset unset log date mkdir cd".split())
"""Commands that neither take an argument away nor leave the loop."""
ANY = ("*", "?*")


@rule("warning", silent="the script goes round without a word")
def arguments_endless(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "shift" not in source.text or "esac" not in source.text:
            continue
        for loop in _loops(shell_blocks(source)):
            for pattern, is_missing in _stuck(loop):
                if is_missing and GETOPT.search(source.text):
                    continue
                yield finding(
                    pattern,
                    "No branch takes other arguments away: with any other argument this loop runs forever"
                    if is_missing
                    else f"The branch {pattern} does not shift: with this argument the loop runs forever",
                    advice='add *) echo "unknown argument: $1" >&2; exit 2 ;;' if is_missing else "add shift to it",
                )


def _loops(blocks: tuple[Block, ...]) -> Iterator[Block]:
    """The loops that go on as long as an argument is left."""
    for block in blocks:
        if block.kind == "loop" and _asks_for_arguments(block):
            yield block
        for body in block.bodies:
            yield from _loops(body)


def _asks_for_arguments(block: Block) -> bool:
    commands = [each.command for each in block.condition if each.command is not None]
    if len(commands) != 1 or commands[0].name not in TESTS:
        return False
    return ARGUMENTS_LEFT.search(" ".join([*commands[0].words[1:], ""])) is not None


def _stuck(loop: Block) -> Iterator[tuple[Located, bool]]:
    """The first branch with which a pass changes nothing, or the test of the loop where no branch takes the rest."""
    body = loop.bodies[0]
    cases = [block for block in body if block.items]
    if len(cases) != 1 or not all(_stays(block) for block in body if block is not cases[0]):
        return
    case = cases[0]
    stuck = [pattern for pattern, branch in zip(case.items, case.bodies) if all(map(_stays, branch))]
    if stuck:
        yield stuck[0], False
    elif not any(pattern in ANY for pattern in case.items):
        yield from ((each.command.words[0], True) for each in loop.condition if each.command is not None)


def _stays(block: Block) -> bool:
    """Whether a statement surely neither takes an argument away nor leaves the loop."""
    if block.kind == "function":
        return True
    if block.command is not None:
        return not block.command.words or block.command.words[0] in STAYS
    return bool(block.bodies) and all(_stays(each) for body in (block.condition, *block.bodies) for each in body)
