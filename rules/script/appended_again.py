"""A script that runs again and again appends the same lines each time.

## What it finds
`>>` or `tee -a` with a line of its own to a login file (`.bashrc`, `.profile`) or to `/etc/fstab`, `/etc/hosts`,
`/etc/sysctl.conf`, `/etc/environment`, `config.txt` and the like, outside of branches, in a script that is for more
than one run: its name, or that of a script which calls it, says that it updates or deploys something.

Silent where the script has to do with the file otherwise (`grep`, `sed`, a new file), ends early where a file is there,
or builds an image.

## Why it matters on a robot
After ten updates the workspace is sourced ten times in each shell, which then takes seconds to open, and a path that
was taken out once is still in the other nine lines. A second entry of `/etc/fstab` for one place, or a second overlay
in `config.txt`, is an error of its own.

## Bad
```sh
# update_workspace.sh
colcon build
echo "source ~/rover_ws/install/setup.bash" >> ~/.bashrc
```

## Good
```sh
# update_workspace.sh
colcon build
line="source ~/rover_ws/install/setup.bash"
grep -qxF "$line" ~/.bashrc || echo "$line" >> ~/.bashrc
```

## When to ignore it
When the script is never run twice for the same user.

## References
- bash(1), "Appending Redirected Output"
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

FILE = regex(
    r"(?:~|\$HOME|\$\{HOME\}|\{\{ HOME \}\}|/home/[^/]+|/root)/\.(?:bashrc|profile|zshrc|bash_profile|bash_aliases)"
    r"|/etc/(?:fstab|hosts|environment|modules|profile|bash\.bashrc|sysctl\.conf|sysctl\.d/[\w.-]+|crontab|exports"
    r"|rc\.local|sudoers|dhcpcd\.conf|network/interfaces|security/limits\.conf|ssh/sshd_config)"
    r"|/boot/(?:firmware/)?config\.txt"
)
AGAIN = regex(r"(?i)(?:^|[_.-])(?:update|upgrade|deploy|sync)(?:[_.-]|$)")
"""Names of scripts that are for more than one run."""
OF_IMAGE = regex(r"\b(?:chroot|debootstrap|systemd-nspawn|losetup|qemu-\w+)\b")
"""The script makes an image, anew each time."""
LEAVES = regex(r"[ \t]-[efdhL][ \t][^\n]{0,200}(?:\n[^\n]{0,200}){0,4}?\bexit\b")
"""The script may end early where something is there."""


@rule("warning", silent="the shell reads the same line once more")
def appended_again(robot: Robot) -> Iterator[Finding]:
    found: dict[Source, list[tuple[Located, str]]] = {}
    for source, written in robot.scripts.written(">>", "tee"):
        is_own = written.text is not None and str(written.text).strip() and FILE.fullmatch(written.path)
        if (
            is_own
            and written.appends
            and written.certain
            and not source.matches(LEAVES)
            and not source.matches(OF_IMAGE)
        ):
            found.setdefault(source, []).append((written.where, written.path.rpartition("/")[2]))
    for source, places in found.items():
        other = {name for name in dict.fromkeys(name for _, name in places) if _has_to_do(source, name)}
        left = [(where, name) for where, name in places if name not in other]
        if not left or robot.scripts.is_for_image(source) or robot.scripts.sets_up_image(source):
            continue
        again = _again(robot, source)
        if again is not None:
            (first, name), *others = left
            yield finding(
                first,
                f"Each run appends this to {name} once more: {again.basename} is for more than one run",
                advice=f"append only what is not there: grep -qxF 'LINE' {name} || echo 'LINE' >> {name}",
                related=[note(each, "and this") for each, _ in others[:9]],
                confidence="medium",
            )


def _has_to_do(source: Source, name: str) -> bool:
    """Whether the script reads, changes or replaces the file as well."""
    reads = r"\b(?:grep|sed|awk|rg|cp|mv|rm|tee(?![ \t]+(?:-a|--append)))\b[^\n]{0,300}"
    changes = r"^[ \t]*(?:sudo[ \t]+)?(?:perl|python3?|ed|ex|truncate|crudini|augtool|git)\b[^\n]{0,300}"
    other = re.compile(rf"(?:{reads}|{changes}|(?<!>)>[ \t]*[^\s>&]{{0,200}}){re.escape(name)}", re.M)
    return other.search(source.text) is not None


def _again(robot: Robot, source: Source) -> Source | None:
    """The script that is for more than one run: this one, or one that calls it."""
    if _is_for_more(source):
        return source
    callers = (each for each in robot.of_kind("shell-script") if each is not source and _is_for_more(each))
    return next((each for each in callers if _calls(robot, each, source)), None)


def _is_for_more(source: Source) -> bool:
    return AGAIN.search(source.basename) is not None


def _calls(robot: Robot, caller: Source, source: Source) -> bool:
    if source.basename not in caller.text:
        return False
    return any(
        source.basename == run.text(word).rpartition("/")[2]
        for found, run in robot.scripts.run(source.basename, "bash", "sh", "source", ".")
        if found is caller
        for word in run.words[:2]
    )
