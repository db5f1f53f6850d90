"""One SSH key opens several robots.

## What it finds
The same public key in the authorized_keys files of several robots of the tree.

## Why it matters on a robot
Anybody who gets the one private key, from a laptop or from a stolen robot, has access to all robots. The key cannot
be withdrawn for one robot alone.

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

## When to ignore it
When the key belongs to a person or a hardware token and is allowed to open every robot.

## References
- sshd(8), "AUTHORIZED_KEYS FILE FORMAT"
- ssh-keygen(1), "CERTIFICATES"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

KEY = regex(r"^(?!#).*?\b(?:ssh-(?:rsa|dss|ed25519)|ecdsa-sha2-\w+|sk-[\w@.-]+)[ \t]+(AAAA[A-Za-z0-9+/=]{30,})", re.M)


@rule("warning", silent="each robot accepts the key", tags=["CWE-321"])
def ssh_key_shared(robot: Robot) -> Iterator[Finding]:
    known: dict[str, Located] = {}
    for source in robot.of_kind("authorized-keys"):
        for match in KEY.finditer(source.text):
            place = source.located(*match.span(1))
            first = known.setdefault(match[1], place)
            if first.span.source is not source and source.judged and machine(first) != machine(place):
                yield finding(
                    place.span.source.span(place.span.start, place.span.start + 12),
                    "The same key opens another robot of this tree: its owner has access to all of them",
                    advice="use a separate key for each robot, or an SSH CA",
                    related=[note(first.span.source.span(first.span.start, first.span.start + 12), "the same key")],
                )


def machine(place: Located) -> str:
    """The part of the name before the path on the robot, or else the folder."""
    source = place.span.source
    path = source.robot_path
    return source.name.removesuffix(path.lstrip("/")) if path else source.name.rpartition("/")[0]
