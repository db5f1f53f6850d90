"""A private key is in the repository.

## What it finds
`enclaves/.../key.pem`, or a key below `private` of a keystore, that is part of the repository. If the
repository has a git index, only files that git tracks are reported. Folders of tests and examples are
skipped. All keys of a keystore are one finding, at the key of its authority if that is there. It is a warning where the
tree has no unit and no compose file: nothing tells then that a robot uses the keystore.

## Why it matters on a robot
Everyone who can read the repository, or its history, can join the robot's network as the motor controller,
and with the authority's key create new identities for the whole fleet.

## Bad
```text
keystore/private/ca.key.pem
keystore/enclaves/lawn/driver/key.pem
```

## Good
```text
keystore/public/ca.cert.pem
keystore/enclaves/lawn/driver/permissions.xml
```

## When to ignore it
If the keystore is for simulation or continuous integration only and no robot trusts its authority.

## References
- ROS 2 documentation, "Deployment Guidelines" of security
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

MOST_NAMED = 10


@rule("error", silent="git stores keys like any other file", tags=["CWE-321"])
def keystore_committed(robot: Robot) -> Iterator[Finding]:
    keystores: dict[str, list[Source]] = {}
    for source in robot.of_kind("sros2-key"):
        sample = re.search(r"(?:^|/)(?:tests?|fixtures?|examples?|samples?)/", source.name)
        if source.judged and not sample and robot.sros2.ships(source):
            keystores.setdefault(_keystore(source), []).append(source)
    for keys in keystores.values():
        first, *others = sorted(keys, key=lambda key: not _is_of_authority(key))
        deployed = bool(robot.units.services or robot.of_kind("compose"))
        yield finding(
            first,
            f"A private key is in the repository: whoever reads it can {_power(first, deployed)}",
            advice="remove it from the history, ignore it, and create new keys",
            related=[note(other, f"with this one, too: {_power(other, deployed)}") for other in others[:MOST_NAMED]],
            severity=None if deployed else "warning",
        )


def _keystore(key: Source) -> str:
    return re.split(r"(?:^|/)(?:private|enclaves)/", key.name)[0]


def _is_of_authority(key: Source) -> bool:
    return "/private/" in f"/{key.name}"


def _power(key: Source, deployed: bool) -> str:
    if _is_of_authority(key):
        return f"create identities for {'the whole fleet' if deployed else 'whatever trusts this keystore'}"
    return "use this identity on the robot's network"
