"""Ansible's command module is given what only a shell understands.

## What it finds
In a task with `command:`:
- `&&`, `||`, `|`, `;`, `>`, `<` and `2>&1` as words of their own, outside of quotes;
- a word of the shell as the program: `cd`, `source`, `.`, `export`, `command -v`, `if`, or `NAME=value` before it;
- a second line that begins with a program: the lines are one command;
- a pattern such as `*.deb` of `rm`, `cp`, `mv`, `chmod`, `chown` and the like.

## Why it matters on a robot
The module starts the program itself, without a shell. `cd` and `source` are no programs: the task fails. Otherwise
all that follows is an argument: `echo ... > FILE` prints its arguments and writes no file, `rm -f /tmp/*.deb` removes
nothing, and both tasks are "changed".

## Bad
```yaml
- name: Build the driver
  ansible.builtin.command: cd /opt/arm/driver && make install
```

## Good
```yaml
- name: Build the driver
  ansible.builtin.command:
    cmd: make install
    chdir: /opt/arm/driver
```

## When to ignore it
When the program takes the sign as its argument.

## References
- https://docs.ansible.com/ansible/latest/collections/ansible/builtin/command_module.html
"""

import re
from bisect import bisect_right
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Task
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import tasks
from bringup_lint.api.shell import tokens
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Scalar

SIGNS = frozenset(("&&", "||", "|", ";", "&", ">", ">>", "<", ">&", "&>"))
INNER = frozenset(("find", "test", "[", "expr", "xargs", "parallel", "jq", "awk"))
"""Programs that take such a sign as an argument."""
BUILTINS = frozenset(
    "cd source . export unset alias pushd popd ulimit umask command type set eval if for while [[ !".split()
)
EXPANDING = frozenset(("rm", "cp", "mv", "chmod", "chown", "chgrp", "ls", "cat", "ln"))
PATTERN = regex(r"-?[\w./-]*[*?][\w./*?-]*")
ASSIGNMENT = regex(r"[A-Z_][A-Z0-9_]*=\S")
PROGRAM = regex(
    r"\n[ \t]*(?P<program>sudo|cd|apt(?:-get)?|make|cmake|mkdir|cp|mv|rm|ln|git|wget|curl|tar|chmod|chown|echo|source"
    r"|systemctl|pip3?|python3?|colcon|rosdep|dpkg|export|docker|udevadm|modprobe)[ \t]+[^\s=:]"
)
"""A line that begins with a program."""
CONTINUED = regex(r"(?:\\|&&|\|\|?|;)[ \t]*\Z")
INNER_MODULE = regex(r"(?:ansible\.(?:builtin|legacy)\.)?command[ \t]+(?=\S)")
BRACES = regex(r"\{\{[^{}]{0,400}\}\}|\{%[^{}%]{0,400}%\}")


@rule("error", symptoms=["Error executing command."])
def command_without_shell(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("ansible"):
        if not source.judged or "command" not in source.text:
            continue
        for task in tasks(source):
            for found in filter(None, map(_mistake, _lines(task))):
                where, message = found
                yield finding(
                    where,
                    f"command runs no shell: {message}",
                    advice="write shell in place of command, or a task for each command, with chdir",
                )


def _lines(task: Task) -> Iterator[Located]:
    """The lines that the module gets, on the robot or on the computer that runs Ansible."""
    for module in task.modules:
        given = module.settings.scalar("cmd") if isinstance(module.settings, Mapping) else module.settings
        if isinstance(given, Scalar):
            inner = INNER_MODULE.match(given.value) if module.name in ("action", "local_action") else None
            if module.name == "command":
                yield given.value
            elif inner is not None:
                yield given.value.part(inner.end(), len(given.value))


def _mistake(line: Located) -> tuple[Located, str] | None:
    """The first place that a shell would have to read, and what happens without one."""
    braces = [line.part(*match.span()).span for match in BRACES.finditer(line)]
    starts = [span.start for span in braces]
    read = tokens(line)
    outside = [each for each in read if not _is_within(each.text.span.start, starts, braces)]
    words = [each.text for each in outside if not each.operator]
    if not words or read[0].text is not words[0]:
        return None
    name = program_name(words[0])
    if words[0] in BUILTINS or ASSIGNMENT.match(words[0]):
        return words[0], f"there is no program {words[0]}, and the task fails"
    sign = next((each.text for each in outside if each.operator and _is_alone(each.text)), None)
    if sign is not None and not INNER.intersection(map(program_name, words)):
        return sign, f"'{sign}' and what follows are arguments of {name}"
    second = _second_line(line, words)
    if second is not None:
        return second, f"all lines are one command, and '{second}' are arguments of {name}"
    pattern = next((each for each in words[1:] if PATTERN.fullmatch(each) and each == _written(each)), None)
    if pattern is not None and name in EXPANDING:
        return pattern, f"{name} looks for a file that is called {pattern}"
    return None


def _is_within(place: int, starts: list[int], spans: list[Span]) -> bool:
    at = bisect_right(starts, place) - 1
    return at >= 0 and place < spans[at].end


def _is_alone(sign: Located) -> bool:
    """Whether it is a word of its own, as people write it for a shell."""
    text, (start, end) = sign.span.source.text, sign.span[1:]
    before = text[max(start - 2, 0) : start]
    if sign not in SIGNS or not (before[-1:].isspace() or sign == ";" or re.fullmatch(r"\s[12]", before)):
        return False
    return sign[0] in "<>" or text[end : end + 1] in " \t\n\"'"


def _written(word: Located) -> str:
    return word.span.source.text[word.span.start : word.span.end]


def _second_line(line: Located, words: list[Located]) -> Located | None:
    """What a later line begins with, where that is a program outside of quotes."""
    second = PROGRAM.search(line)
    if second is None or CONTINUED.search(line[: second.start()]):
        return None
    place = line.part(*second.span("program"))
    return place if any(each.span.start == place.span.start for each in words) else None
