"""A script adds a user to a group that nothing creates.

## What it finds
`usermod -aG GROUP` and `gpasswd -a USER GROUP` in a script, with a group that neither Debian and Ubuntu nor a file of
the tree create. Silent where the tree creates groups whose names it takes from variables, for
groups with the name of a package that the script installs, where the failure is expected (`||`), and where the script
looks whether the group is there (`getent group`).

## Why it matters on a robot
usermod ends with "group 'realtime' does not exist" and adds the user to none of the listed groups, `dialout` included.
With `set -e` the set-up stops here; without it the drivers have no access to their ports after the next boot.

## Bad
```sh
sudo usermod -aG realtime,dialout rover
```

## Good
```sh
sudo groupadd -f realtime
sudo usermod -aG realtime,dialout rover
```

## When to ignore it
When a package from outside the distribution creates the group.

## References
- usermod(8), groupadd(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

LISTED = regex(r"-[a-zA-Z]{0,3}G|--groups")
NAME = regex(r"[a-z_][a-z0-9_-]{1,31}")
INSTALLS = regex(r"\b(?:apt|apt-get|dnf|pacman|snap|dpkg|install)\b")
ASKS = regex(r"\bgetent[ \t]+group\b|/etc/group\b")


@rule(
    "warning", confidence="medium", symptoms=["usermod: group '*' does not exist", "gpasswd: group '*' does not exist"]
)
def group_unknown(robot: Robot) -> Iterator[Finding]:
    found: dict[Source, dict[str, list[Located]]] = {}
    for source, run in robot.scripts.run("usermod", "gpasswd"):
        word = _groups(run)
        if word is None or run.command.ends == "||" or run.command.hides_errors:
            continue
        for name in run.text(word).split(","):
            if NAME.fullmatch(name) and not robot.accounts.has_group(name):
                found.setdefault(source, {}).setdefault(name, []).append(word)
    if found and robot.accounts.creates_unnamed:
        return
    for source, names in found.items():
        for name, (first, *others) in names.items():
            if not _comes_with_package(source, name) and not _is_asked_for(source, name):
                yield finding(
                    first,
                    f"Nothing creates the group '{name}': the command fails and adds the user to no group at all",
                    advice=f"run groupadd -f {name} before",
                    related=[note(other, "this fails, too") for other in others],
                )


def _groups(run: Run) -> Located | None:
    """The word of a command that names the groups."""
    if run.name == "usermod":
        return next((group for option, group in zip(run.words[1:], run.words[2:]) if LISTED.fullmatch(option)), None)
    if run.name == "gpasswd" and len(run.words) == 4 and run.words[1] in ("-a", "--add"):
        return run.words[3]
    return None


def _comes_with_package(source: Source, name: str) -> bool:
    """Whether the script installs a package with the name of the group, which may create it."""
    return any(name in line and INSTALLS.search(line) for line in source.text.replace("\\\n", " ").splitlines())


def _is_asked_for(source: Source, name: str) -> bool:
    """Whether the script looks for the group before it uses it."""
    return any(name in line and ASKS.search(line) for line in source.text.splitlines())
