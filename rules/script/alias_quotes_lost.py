"""A script writes an alias whose quotes are lost.

## What it finds
`alias NAME=WORD WORD` in what a script writes to `.bashrc`, `.bash_aliases`, `.profile` or another login file: the
value has more than one word and no quotes.

## Why it matters on a robot
The quotes in the script ended the quotes around the line, and the file has none. The alias is its first word only, and
each new shell says "alias: build: not found". Whoever uses the alias on the robot starts another command.

## Bad
```sh
echo 'alias b='colcon build'' >> ~/.bashrc
```

## Good
```sh
echo "alias b='colcon build'" >> ~/.bashrc
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
