"""A script makes configuration writable for everybody.

## What it finds
`chmod 777`, `chmod 666`, `chmod a+w` and the like on a file or folder in `/etc`, `/usr`, `/boot`, `/lib`, `/opt`,
on a hidden file of a home folder, on a private key, or on a file `.env`.

## Why it matters on a robot
Every service and every user of the robot can change the file. Configuration that root reads, such as /etc/hosts or
a script that a unit runs, lets them become root or lead the robot's traffic elsewhere. sshd refuses keys with such
modes.

## Bad
```sh
sudo chmod 777 /etc/rover/robot.yaml
```

## Good
```sh
sudo chown root:rover /etc/rover/robot.yaml
sudo chmod 664 /etc/rover/robot.yaml
```

## When to ignore it
When the file holds nothing that anything trusts.

## References
- chmod(1)
- CWE-732: Incorrect Permission Assignment for Critical Resource
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

OPEN = regex(r"0?[0-7]?[0-7][0-7][2367]|(?:[ugo]*[ao][ugo]*)?\+r?wx?X?|[ugo]*[ao][ugo]*=r?wx?X?")
STICKY = regex(r"[1357][0-7]{3}|0[1357][0-7]{3}")
TRUSTED = regex(
    r"/(?:etc|usr|boot|lib|opt)/.+|(?:/home/[^/]+|/root|~|\{\{ HOME \}\})/\.[^/]+.*|.*/id_(?:rsa|ed25519|ecdsa)"
    r"|(?:[^*]*/)?\.env"
)
NO_MATTER = regex(r"/(?:logs?|tmp|cache|run|data)(?:/|$)|\.log$|\.Xauth|\.docker\.xauth")


@rule("warning", tags=["CWE-732"], symptoms=["is marked world-writable"])
def world_writable(robot: Robot) -> Iterator[Finding]:
    for _, run in robot.scripts.run("chmod"):
        mode, paths = _opened(run)
        for path, word in paths:
            if TRUSTED.fullmatch(path) and not NO_MATTER.search(path):
                yield finding(
                    word,
                    f"chmod {mode} lets every user and every service of the robot change {path}",
                    advice="give the file to a group that needs it, with mode 664 or 640",
                    confidence=None if run.certain else "medium",
                )


def _opened(run: Run) -> tuple[str, list[tuple[str, Located]]]:
    """The mode that a command gives to everybody, and the paths with their words; no paths for other modes."""
    words = [(run.text(word), word) for word in run.words[1:]]
    plain = [each for each in words if not re.match(r"-[A-Za-z-]", each[0])]
    if not plain or not OPEN.fullmatch(plain[0][0]) or STICKY.fullmatch(plain[0][0]):
        return "", []
    return plain[0][0], plain[1:]
