"""A script goes on after a return that is in no function.

## What it finds
`return` outside a function, in a script for bash that takes arguments or that a file of the tree runs by its path.
Silent if a file of the tree, or the script's own text, says that it is to be sourced, if the line goes on when `return`
fails (`return 2>/dev/null || exit 1`), and after `set -e`.

## Why it matters on a robot
bash ends a script at such a line only when the script is sourced. In one that is run it prints an error and goes on
with the next line: the check before it, of an argument, a device or a user, stops nothing.

## Bad
```sh
#!/bin/bash
if [ $# -ne 1 ]; then
    echo "usage: set_password.sh PASSWORD"
    return 1
fi
```

## Good
```sh
#!/bin/bash
if [ $# -ne 1 ]; then
    echo "usage: set_password.sh PASSWORD"
    exit 1
fi
```

## When to ignore it
When people source the script, though nothing in the tree says so.

## References
- bash(1), "SHELL BUILTIN COMMANDS": return
"""

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import STRICT
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import shell_blocks

BASH = regex(r"#![ \t]*\S*/(?:env[ \t]+)?bash\b")
ENDS = regex(STRICT + r"|BASH_SOURCE|\bsource[ \t]+[\"']?\$\{?0|\(return\b|\$_\b", re.M)
NEAR = 80
"""Characters before the name of a script in which a command that runs or sources it is."""
RUNS = regex(r"(?:^|[\s;&|(\"'`$])(?:\./|bash[ \t]+|sudo[ \t]+)[\w./${}()-]*$")
SOURCES = regex(r"(?:\bsource|(?:^|[\s;&|])\.)[ \t]+[^\n;&|]*$")
ARGUMENTS = regex(r"\$#|\$\{?1\b")
FOR_A_PERSON = regex(
    r"(?m)^[ \t]*(?:unalias\b|alias[ \t]+[\"']?[\w-]+=)|\b(?:source|\.)[ \t]+[\"']?(?:~|\$HOME)/\.bashrc"
)
"""What is of use only in the shell of whoever sources the script."""
TEXTS = (".md", ".rst", ".txt")


@rule("warning", fix="unsafe", symptoms=["can only `return' from a function or sourced script"])
def return_outside_function(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or "return" not in source.text:
            continue
        if not BASH.match(source.text) or ENDS.search(source.text):
            continue
        found = list(_returns(shell_blocks(source)))
        if not found or not _is_run(robot, source):
            continue
        first, *others = found
        yield finding(
            first,
            "bash cannot return from a script that is run: it prints an error and goes on with the next line",
            advice="write exit",
            related=[note(other, "here too") for other in others],
            fix=fix("write exit", *((each, "exit") for each in found)),
        )


def _returns(blocks: Iterable[Block]) -> Iterator[Located]:
    for block in blocks:
        if block.kind == "function":
            continue
        command = block.command
        if command is not None and command.name == "return" and command.ends != "||":
            yield command.words[0]
        for body in (block.condition, *block.bodies):
            yield from _returns(body)


def _is_run(robot: Robot, source: Source) -> bool:
    """Whether the script is one that is run, and nothing sources it."""
    told = [robot.tree.read(path, judged=False) for path in robot.tree.paths if path.endswith(TEXTS)]
    texts = [each.text for each in (*robot.sources, *told) if each is not None and source.basename in each.text]
    before = [
        text[max(0, match.start() - NEAR) : match.start()]
        for text in texts
        for match in re.finditer(rf"(?<![\w.-]){re.escape(source.basename)}\b", text)
    ]
    if any(map(SOURCES.search, before)):
        return False
    taken = ARGUMENTS.search(source.text) is not None and not FOR_A_PERSON.search(source.text)
    return taken or any(map(RUNS.search, before))
