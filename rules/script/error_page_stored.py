"""curl stores the error page of a server as a program or a configuration.

## What it finds
`curl` without `-f` in a script, a build step or a task of Ansible whose output is a file in a `bin` folder, in /etc,
in /opt or among the rules of udev.

Silent for keys, package lists and archives, which apt, gpg and tar refuse, where the status is asked for (`-w`), and
where the file is checked by its sum, is run at once to print its version, or is handed to a shell, which fails.

## Why it matters on a robot
For "404 Not Found" curl ends with success, and the page is the file. `set -e` and `&&` see no failure: the installation
goes on, and what should be a program is the line "Not Found". It is met much later, on the robot.

## Bad
```sh
curl -sSL https://example.com/releases/latest/mapper -o /usr/local/bin/mapper
chmod +x /usr/local/bin/mapper
```

## Good
```sh
curl -fsSL https://example.com/releases/latest/mapper -o /usr/local/bin/mapper
chmod +x /usr/local/bin/mapper
```

## When to ignore it
When something that is not in the tree checks the file.

## References
- curl(1), "-f, --fail"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import every_command
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped

VALUED = frozenset("AbcCdDeEFHKmoPQrtTuUwxXyYz")
"""Letters of options that take a value."""
STOPS = ("--fail", "--fail-with-body", "--write-out", "--head")
PLACE = regex(
    r"(?:/usr(?:/local)?|~/\.local|\$\{?HOME\}?/(?:\.local/)?)?/?s?bin/.+|/etc/(?!apt/).+|(?:/usr)?/lib/udev/.+|/opt/.+"
)
REFUSED = regex(r"keyring|\.(?:gpg|asc|key|pem|tar|tgz|gz|xz|bz2|zst|zip|deb|rpm|whl|run)\b|\$\{?\w+\}?$")
BETWEEN = r"\s\"'`;|&()<>=:,/"
WORD = regex(rf"[^{BETWEEN}]+")
LOOKS = (
    regex(r"(?:sum|verify|\bfile|\bgrep|\bhead)\b([^\n]*)"),
    regex(r"^([^\n]*)sum\b", re.M, "sum"),
    regex(rf"(?<![^{BETWEEN}])([^{BETWEEN}]+)[\"']?[ \t]+(?:--)?(?:version|help)"),
    regex(r"\b(?:(?:ba|da|z)?sh|python3?)[ \t]+(?:-\w{1,8}[ \t]+){0,4}([^\s;|&]{1,200})"),
)
URL = regex(r"https?://")


@rule("warning", silent="curl ends with success, as for any page")
def error_page_stored(robot: Robot) -> Iterator[Finding]:
    for command in every_command(robot.runners):
        if any(word.endswith("curl") for word in command.words[:4]):
            stored = _stored(command)
            if stored is not None and not _is_checked(stored):
                yield finding(
                    stored,
                    f"Where the server answers with an error, curl stores its page as {stored} and succeeds",
                    advice="write curl -f",
                )


def _stored(command: Command) -> Located | None:
    """The file in which the answer of a server ends, whatever this is."""
    words = unwrapped(command.words)
    if not words or program_name(words[0]) != "curl" or not any(map(URL.search, words)):
        return None
    target = next((each.target for each in command.redirects if each.writes), None)
    for at, word in enumerate(words[1:], 1):
        if word.startswith("--"):
            if word.startswith(STOPS):
                return None
            if word == "--output":
                target = words[at + 1] if at + 1 < len(words) else None
        elif word.startswith("-") and not words[at - 1].startswith("-o"):
            letters = re.match(rf"-([^{''.join(VALUED)}]*)(.?)", word)
            if letters is None or "f" in letters[1] or "I" in letters[1] or letters[2] == "w":
                return None
            if letters[2] == "o":
                rest = word.part(letters.end(), len(word))
                target = rest if rest else words[at + 1] if at + 1 < len(words) else None
    return target if target is not None and PLACE.fullmatch(target) and not REFUSED.search(target) else None


def _is_checked(stored: Located) -> bool:
    """Whether the script or image looks at the file."""
    source = stored.span.source
    asked = source.once(_is_checked, lambda: _looked_at(source.text))
    return asked.issuperset(WORD.findall(stored.rpartition("/")[2]))


def _looked_at(text: str) -> set[str]:
    """The words for which a script or image looks at a file, with and without their suffixes."""
    words = {word for pattern in LOOKS for found in pattern.finditer(text) for word in WORD.findall(found[1])}
    return words | {word.partition(".")[0] for word in words} | {word.rpartition(".")[0] for word in words}
