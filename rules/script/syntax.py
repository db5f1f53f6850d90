"""A script that the shell cannot read to its end.

## What it finds
Scripts for bash and sh with a quote, backtick or bracket that is not closed, an `if`, `for`, `while`, `case` or `{`
without its end, and a `then`, `else`, `fi`, `do`, `done`, `esac`, `;;` or bracket that does not fit its place. Also
aliases with a quote or bracket that is not closed, and three backticks of Markdown in the place of a command, where
no `exit`, `kill` or `exec` of a program is before them. Not reported: templates, scripts with carriage returns, and
places that an option of the shell may decide, as `extglob`.

## Why it matters on a robot
The shell reads a command, runs it, and reads the next. What comes before the mistake is done, and the mistake and all
that follows is not: the robot is left half installed, or its start script ends before it has started anything.

## Bad
```sh
sudo cp `ros2 pkg prefix mower`/share/mower/`99-mower.rules /etc/udev/rules.d/
```

## Good
```sh
sudo cp "$(ros2 pkg prefix mower)/share/mower/99-mower.rules" /etc/udev/rules.d/
```

## When to ignore it
Never; `bash -n SCRIPT` says the same.

## References
- bash(1), "SHELL GRAMMAR"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Mistake
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import syntax_mistake

SHELL = regex(r"#!\s*\S*/(?:env\s+(?:-S\s+)?)?(?:ba|da)?sh\b|(?!#!)")
OTHER = regex(r"\.(?:zsh|fish|csh|ksh)$|\bextglob\b")
ALIAS = regex(r"^[ \t]*alias[ \t]+(?P<name>[\w-]{1,60})='(?P<body>[^'\n]{0,2000})'[ \t]*$", re.M, "alias")
FENCE = "```"
LEAVES = ("exit", "kill")
CLOSING = {"`": "`", "'": "'", '"': '"', "$'": "'", "(": ")", "$(": ")", "<(": ")", ">(": ")", "${": "}", "[[": "]]"}


@rule(
    "error",
    symptoms=[
        "syntax error near unexpected token",
        "unexpected EOF while looking for matching",
        "syntax error: unexpected end of file",
        "Syntax error: Unterminated quoted string",
    ],
)
def syntax(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or source.origin is not None or not SHELL.match(source.text):
            continue
        mistake = None if OTHER.search(source.name) or OTHER.search(source.text) else syntax_mistake(source.text)
        if mistake is not None:
            what, advice = _explained(mistake)
            yield finding(
                source.located(mistake.at, mistake.end),
                f"{what}: the shell stops here with a syntax error, and nothing that follows is run",
                advice=advice,
            )
        else:
            yield from _of_aliases(source)
            yield from _of_fences(source)


def _of_aliases(source: Source) -> Iterator[Finding]:
    """The aliases that the shell cannot read when somebody uses them."""
    for alias in ALIAS.finditer(source.text):
        mistake = syntax_mistake(alias["body"])
        if mistake is not None and mistake.kind == "unclosed":
            what, advice = _explained(mistake)
            at = alias.start("body")
            yield finding(
                source.located(at + mistake.at, at + mistake.end),
                f"{what}: the alias {alias['name']} ends with a syntax error",
                advice=advice,
            )


def _of_fences(source: Source) -> Iterator[Finding]:
    """The first of the backticks that a text with a script in it has around that."""
    if FENCE not in source.text:
        return
    commands = [command for command in shell_commands(source) if command.words]
    first = next((each.words[0] for each in commands if each.words[0].span.text.startswith(FENCE)), None)
    if first is not None and not any(
        command.name in LEAVES or (command.name == "exec" and len(command.words) > 1)
        for command in commands
        if command.words[0].span.start < first.span.start
    ):
        yield finding(
            first,
            "These backticks are of Markdown: the shell takes the text from here on for commands",
            advice="end the script before them",
        )


def _explained(mistake: Mistake) -> tuple[str, str]:
    if mistake.kind == "unclosed":
        return f"This {mistake.word} is never closed", f"add the missing {CLOSING[mistake.word]}, or remove this one"
    if mistake.kind == "missing":
        return f"This {mistake.word} has no {mistake.wanted}", f"add {mistake.wanted}"
    word = mistake.word.strip() or "The end of the line"
    return f"{word} does not fit here", "'bash -n' with the name of the script reads it without running it"
