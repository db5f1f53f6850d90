"""A range in braces has a variable.

## What it finds
`for i in {1..$n}` in a script of bash or sh that does not use `eval`.

## Why it matters on a robot
Bash expands braces before variables: the loop runs once, with the text `{1..4}`. One robot, wheel or camera of four is
set up, or none.

## Bad
```bash
for i in {1..$count}; do
```

## Good
```bash
for ((i = 1; i <= count; i++)); do
```

## When to ignore it
Never for bash. zsh and ksh expand variables first; scripts that name them in their first line are not reported.

## References
- bash(1), "Brace Expansion"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import shell_blocks

END = r"(?:-?\d+|\$\{?\w+\}?|\$\{#\w+\[[@*]\]\}|\$\([^()]*\)|\$\(\([^()]*\)\))"
RANGE = regex(rf"\{{(?=[^$]*\$){END}\.\.{END}(?:\.\.{END})?\}}")
OTHER = regex(r"\A#![^\n]*\b(?:zsh|ksh)\b|\beval\b", hints="zsh ksh eval")


@rule("error", symptoms=['syntax error: operand expected (error token is "{1..*}")'])
def brace_range(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if source.judged and not source.template and ".." in source.text and not OTHER.search(source.text):
            for block in _loops(shell_blocks(source)):
                for word in block.items:
                    if RANGE.fullmatch(word.span.text):
                        yield finding(
                            word,
                            f"Braces are expanded before variables: the loop runs once, with the text '{word}'",
                            advice='write for ((i = 1; i <= n; i++)), or $(seq 1 "$n")',
                        )


def _loops(blocks: tuple[Block, ...]) -> Iterator[Block]:
    """The ``for`` loops of a script, at any depth."""
    for block in blocks:
        if block.kind == "for":
            yield block
        for body in block.bodies:
            yield from _loops(body)
