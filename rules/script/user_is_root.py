"""A script that root runs means its user with `$USER`.

## What it finds
`usermod`, `adduser`, `gpasswd` and `loginctl enable-linger` with `$USER`, `$LOGNAME`, `$(whoami)` or `$(id -un)`, in a
script that refuses anybody but root, or that another script, a comment of its own or a page of the tree starts with
`sudo`. Silent where it asks for `SUDO_USER`.

## Why it matters on a robot
sudo sets USER to root. The group is given to root, who needs it least; the robot's user still may not open
`/dev/ttyUSB0` or talk to docker, though the set-up has reported success.

## Bad
```sh
# usage: sudo ./setup.sh
usermod -aG dialout "$USER"
```

## Good
```sh
# usage: sudo ./setup.sh
usermod -aG dialout "${SUDO_USER:-$USER}"
```

## When to ignore it
When it is root for whom this is meant.

## References
- sudoers(5), set_logname
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

GIVES = ("usermod", "adduser", "gpasswd", "loginctl")
SELF = regex(r"\$(?:USER|\{USER\}|LOGNAME|\{LOGNAME\}|\((?:whoami|id -un)\))|`(?:whoami|id -un)`")
OTHER = regex(
    r"\bSUDO_USER\b|\blogname\b|\bPKEXEC_UID\b|\b(?:USER|LOGNAME)=|\bread\b[^\n]{0,60}\bUSER\b|\bsu[ \t]+-"
    r"|\bfor[ \t]+USER\b"
)
ASKS = regex(
    r"(?:\bEUID\b|\bid[ \t]+-u\b|\bUID\b)[^\n]{0,20}(?:-ne|!=|-gt)[ \t]*[\"']?0"
    r"(?![^\n]{0,20}&&[^\n{]{0,80}=)"
)
REFUSES = regex(
    r"(?:(?!\b(?:fi|else|sudo[ \t]+-[vn]\b|(?:command -v|which|type)[ \t]+sudo"
    r"|sudo[ \t]+[^\n]{0,20}\$(?:0|\{?BASH_SOURCE)))[\s\S]){0,300}?\bexit\b"
)
COMMON = regex(r"(?:install|setup|run|start|build|update|bootstrap|init|main|deploy|configure)\.(?:sh|bash)")
"""Names that scripts of other projects have, too, of which the same page may speak."""
PAGE = regex(r"\.(?:md|rst|txt)$", re.I)
AS_USER = regex(r"\b(?:sudo|runuser)\b[^;&|]{0,80}[ \t]-i?u\b")
FORBIDS = regex(r"\b(?:not|never|without|don['’]?t|instead of)\b[^.:]{0,40}$", re.I)
MOST = 100_000


@rule("warning", confidence="medium", silent="root gets the group, and usermod succeeds")
def user_is_root(robot: Robot) -> Iterator[Finding]:
    found: dict[Source, list[Located]] = {}
    for source, run in robot.scripts.run(*GIVES):
        itself = next((word for word in run.words[1:] if SELF.fullmatch(word)), None)
        is_theirs = itself is not None and AS_USER.search(itself.span.source.line_before(itself.span.start))
        if itself is not None and not is_theirs and not OTHER.search(source.text):
            found.setdefault(source, []).append(itself)
    for source, (first, *others) in found.items():
        why = "" if robot.scripts.is_for_image(source) else _why_root(robot, source)
        if why:
            yield finding(
                first,
                f"Root runs this script ({why}): {first} is root here, and the robot's user gets nothing",
                advice='write "${SUDO_USER:-$USER}"',
                related=[note(each, "here too") for each in others[:20]],
            )


def _why_root(robot: Robot, source: Source) -> str:
    """What says that root runs the script; empty when nothing does."""
    asks = ASKS.search(source.text)
    if asks and REFUSES.match(source.text, asks.end()):
        return "it refuses anybody else"
    is_common = COMMON.fullmatch(source.basename) is not None
    shown = "/".join(source.name.split("/")[-2:]) if is_common else source.basename
    if len(list(robot.tree.named(source.basename))) != 1 or (is_common and "/" not in shown):
        return ""
    path = rf"[\"']?(?:[\w./~${{}}-]*/)?{re.escape(shown)}(?![\w.-])"
    started = re.compile(rf"(?<![\w-])sudo[ \t]+(?:-H[ \t]+)?(?:(?:ba)?sh[ \t]+)?{path}")
    texts = (*(each.text for each in robot.sources), *robot.tree.pages(PAGE, MOST))
    calls = ((text[: match.start()], match[0]) for text in texts for match in started.finditer(text))
    told = next((call for before, call in calls if not FORBIDS.search(before.rpartition("\n")[2])), "")
    return f"'{told}'" if told else ""
