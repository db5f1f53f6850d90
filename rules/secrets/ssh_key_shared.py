"""One SSH key opens several robots or accounts.

## What it finds
The same public key in the authorized_keys of several robots of the tree.

## Why it matters on a robot
Whoever gets hold of the one private key, from a laptop or from one robot that was stolen, has all of them;
and it cannot be withdrawn for one alone.

## Bad
```ini
robots/tern/authorized_keys:  ssh-ed25519 AAAA... fleet
robots/heron/authorized_keys: ssh-ed25519 AAAA... fleet
```

## Good
```ini
robots/tern/authorized_keys:  ssh-ed25519 AAAA... operator@tern
robots/heron/authorized_keys: ssh-ed25519 BBBB... operator@heron
```

## References
- sshd(8), "AUTHORIZED_KEYS FILE FORMAT"
- ssh-keygen(1), "CERTIFICATES"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

KEY = re.compile(
    r"^(?!#).*?\b(?:ssh-(?:rsa|dss|ed25519)|ecdsa-sha2-\w+|sk-[\w@.-]+)[ \t]+(AAAA[A-Za-z0-9+/=]{30,})", re.M
)


@rule("warning", tags=["CWE-321"])
def ssh_key_shared(robot: Robot) -> Iterator[Finding]:
    known = {}
    for source in robot.of_kind("authorized-keys"):
        for match in KEY.finditer(source.text):
            place = source.located(*match.span(1))
            first = known.setdefault(match[1], place)
            if first.span.source is not source and source.judged and machine(first) != machine(place):
                yield finding(
                    place.span.source.span(place.span.start, place.span.start + 12),
                    "The same key opens another robot of this tree: who has it has all of them",
                    advice="a key for each robot, or an SSH CA",
                    related=[note(first.span.source.span(first.span.start, first.span.start + 12), "here too")],
                )


def machine(place):
    """What stands before the path on the robot, or the folder."""
    source = place.span.source
    path = source.robot_path
    return source.name.removesuffix(path.lstrip("/")) if path else source.name.rpartition("/")[0]
