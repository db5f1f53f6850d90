"""A script writes an alias or a command to a login file whose quotes are lost.

## What it finds
`alias NAME=WORD WORD` in what a script writes to `.bashrc`, `.bash_aliases`, `.profile` or another login file: the
value has more than one word and no quotes. And `echo "eval "$(COMMAND)""` to such a file: the quotes before `$(` end
those of the line.

## Why it matters on a robot
The quotes in the script ended the quotes around the line, and the file has none. The alias is its first word only, and
each new shell says "alias: build: not found". Whoever uses the alias on the robot starts another command. A `$(...)`
outside of the quotes runs while the script does: the file gets its output of today, in one line and without quotes,
and each new shell reads that.

## Bad
```sh
echo 'alias b='colcon build'' >> ~/.bashrc
```

## Good
```sh
echo "alias b='colcon build'" >> ~/.bashrc
echo 'eval "$(register-python-argcomplete ros2)"' >> ~/.bashrc
```

## When to ignore it
Never: the line does not do what it says.

## References
- bash(1), "QUOTING" and "ALIASES"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

LOGIN_FILES = (".bashrc", ".bash_aliases", ".profile", ".bash_profile", ".zshrc", "bash.bashrc", "profile.d")
ALIAS = regex(
    r"^[ \t]*alias[ \t]+(?P<name>[\w-]+)=(?P<value>[^\s\"'$\\{}]+)[ \t]+(?P<next>[\w./-]+)(?![\w./-]*=)", re.M
)

NESTED = regex(r"\"eval[ \t]+\"(?:\$\([^()\n]{1,200}\)|`[^`\n]{1,200}`)\"\"")


@rule("warning", symptoms=["alias: ", ": not found"])
def alias_quotes_lost(robot: Robot) -> Iterator[Finding]:
    for _, written in robot.scripts.written("alias"):
        if written.text is None or not any(name in written.path for name in LOGIN_FILES):
            continue
        for match in ALIAS.finditer(str(written.text)):
            yield finding(
                written.where,
                f"The file gets 'alias {match['name']}={match['value']} {match['next']}' without quotes: the alias is "
                f"'{match['value']}' only",
                advice="put the whole line in double quotes and the value in single ones",
            )
    for _, run in robot.scripts.run("echo"):
        files = [run.text(each.target) for each in run.command.redirects if each.writes and each.target is not None]
        nested = [word for word in run.words[1:] if NESTED.fullmatch(word.span.text)]
        if nested and any(name in path for path in files for name in LOGIN_FILES):
            yield finding(
                nested[0],
                "The quotes before $(...) end those of the line: the command runs now, and the file gets its output in "
                "one line without quotes",
                advice="put the whole line in single quotes",
            )
