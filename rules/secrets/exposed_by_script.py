"""A script shows a secret to others.

## What it finds
- A variable called `..._TOKEN`, `..._PASSWORD` or the like in the URL that a script hands to `git`, `curl` or `wget`.
- A line with the value of such a variable after its name (`password=${PASSWORD}`), in a script that appends what it
  says to a log file.

## Why it matters on a robot
Every local user reads command lines in the process list, `git clone` stores the URL with the token in `.git/config`,
and its error messages repeat it. A log is copied into bug reports and read by people who were never to know the
password of the Wi-Fi.

## Bad
```sh
git clone "https://$GIT_USER:$GIT_TOKEN@git.example.org/fleet.git"
```

## Good
```sh
git -c credential.helper='store --file /etc/rover/git-credentials' clone https://git.example.org/fleet.git
```

## When to ignore it
When the token can only read what is public anyway.

## References
- gitcredentials(7)
- proc(5), /proc/pid/cmdline
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

NAME = r"\w*(?:PASS(?:WORD|WD|PHRASE)?|PSK|TOKEN|SECRET|_PAT)\w{0,3}"
IN_URL = regex(
    rf"\b(?:git|curl|wget)\b[^\n|;&#]{{0,300}}?(?P<where>https?://(?:[^\s/@\"']{{0,80}}:)?\$\{{?{NAME}\}}?@)",
    re.I,
    hints="http",
)
SHOWN = regex(
    rf"^[ \t]*(?:\w+=|echo\b|printf\b|logger\b)[^\n|]{{0,300}}?"
    rf"(?P<where>\b(?:password|passwd|psk|token|secret)[\"']?[ \t]*[=:][ \t]*\$\{{?{NAME}\}}?)[^\n|]*$",
    re.I | re.M,
)
LOGS = regex(r">>[ \t]*[\"']?[^\s\"']*log|\btee[ \t]+-a[ \t]+[\"']?[^\s\"']*log|\blogger\b", re.I)
COMMENT = regex(r"^[ \t]*#")


@rule("warning", silent="the output that shows the secret differs in each script", tags=["CWE-214", "CWE-532"])
def exposed_by_script(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged:
            continue
        yield from _findings(
            list(_found(source, IN_URL)),
            "The secret is in the command line: every local user can read it, and git keeps it in .git/config",
            "use a credential helper, or a file of mode 0600",
        )
        if LOGS.search(source.text):
            yield from _findings(
                list(_found(source, SHOWN)),
                "The value of the secret goes to the log",
                "leave it out of the line",
            )


def _found(source: Source, pattern: re.Pattern[str]) -> Iterator[Located]:
    for match in pattern.finditer(source.text):
        start = source.text.rfind("\n", 0, match.start("where")) + 1
        if not COMMENT.match(source.text[start : match.start("where")]):
            yield source.located(*match.span("where"))


def _findings(places: list[Located], message: str, advice: str) -> Iterator[Finding]:
    if places:
        first, *others = places
        yield finding(first, message, advice=advice, related=[note(each, "here too") for each in others])
