"""An enclave has missing files or broken links.

## What it finds
An enclave without one of the files that the RMW opens, or with broken links. In a repository, which should
not contain keys, only enclaves with a certificate are checked, and a missing key is not reported. It is an error where
`ROS_SECURITY_STRATEGY` is `Enforce`.

## Why it matters on a robot
The participant cannot be created (code 117): no node of the enclave starts.

## Bad
```text
enclaves/lawn/driver/cert.pem
enclaves/lawn/driver/permissions.p7s
```

## Good
```text
enclaves/lawn/driver/cert.pem
enclaves/lawn/driver/key.pem
enclaves/lawn/driver/identity_ca.cert.pem -> ../../../public/identity_ca.cert.pem
enclaves/lawn/driver/permissions_ca.cert.pem -> ../../../public/permissions_ca.cert.pem
enclaves/lawn/driver/governance.p7s -> ../../governance.p7s
enclaves/lawn/driver/permissions.p7s
```

## When to ignore it
If the missing files are created or mounted when the robot is provisioned.

## References
- sros2, create_keystore and create_enclave; Cyclone DDS 0.10.5 with security
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

MOST = 20


class Incomplete(NamedTuple):
    """An enclave without files that its nodes need."""

    where: Source
    message: str
    advice: str


@rule("error", symptoms=["File could not be found, opened or is empty"])
def keystore_layout(robot: Robot) -> Iterator[Finding]:
    whole = robot.tree.complete
    for keystore in robot.sros2.keystores:
        alike: dict[str, list[Incomplete]] = {}
        for enclave in keystore.enclaves.values():
            where = robot.sros2.anchor(enclave.folder)
            dangling = enclave.broken_links(robot.tree)
            missing = [name for name in enclave.missing() if whole or name != "key.pem"]
            if dangling:
                message = f"The links {', '.join(dangling)} of enclave {enclave.path} are broken"
                advice = "copy the whole keystore with its links, or replace the links with the files"
                alike.setdefault(advice, []).append(Incomplete(where, message, advice))
            if missing and (whole or "cert.pem" in enclave.files):
                message = f"Enclave {enclave.path} has no {', '.join(missing)}"
                advice = "copy the whole keystore, or create the enclave again"
                alike.setdefault(advice, []).append(Incomplete(where, message, advice))
        enforced = any(each.text == "Enforce" for each in robot.ros.of("ROS_SECURITY_STRATEGY"))
        yield from (_report(found, enforced) for found in alike.values())


def _report(found: list[Incomplete], enforced: bool) -> Finding:
    """One finding for all enclaves of a keystore that lack the same sort of file."""
    first, *others = found
    return finding(
        first.where,
        f"{first.message}: "
        + (
            "code 117, its nodes do not start"
            if enforced
            else "its nodes start without security, or not at all with Enforce"
        ),
        advice=first.advice,
        related=[note(other.where, other.message) for other in others[:MOST]],
        severity=None if enforced else "warning",
    )
