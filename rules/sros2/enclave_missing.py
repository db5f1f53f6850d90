"""A process selects an enclave that the keystore does not have.

## What it finds
An enclave named by `--enclave` or `ROS_SECURITY_ENCLAVE_OVERRIDE` that none of the keystores in the tree
contains. Without a keystore in the tree, one that no policy of the tree describes, although a policy has others
below the same first name, and nothing else of the tree names it (a warning).

## Why it matters on a robot
With Enforce the process ends (`directory does not exist`). With Permissive it runs unsecured.

## Bad
```sh
ros2 run lawn driver --ros-args --enclave /lawn/motor
# keystore/enclaves/lawn/driver
```

## Good
```sh
ros2 run lawn driver --ros-args --enclave /lawn/driver
# keystore/enclaves/lawn/driver
```

## When to ignore it
If the enclave is created on the robot when it is provisioned, and the keystore in the tree is only a part of
it.

## References
- rcl, security.c; tested with the real rcl of Jazzy
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule(
    "error",
    symptoms=[
        "SECURITY ERROR: unable to find a folder matching the name",
        "SECURITY ERROR: directory",
        "SECURITY ERROR: directory '*/enclaves/*' does not exist",
    ],
)
def enclave_missing(robot: Robot) -> Iterator[Finding]:
    for name in robot.sros2.selected:
        keystores = [each for each in robot.sros2.keystores if robot.same_robot(name, robot.sros2.anchor_of(each))]
        known = sorted({path for keystore in keystores for path in keystore.enclaves})
        if not robot.sros2.keystores:
            yield from _not_in_policy(robot, name)
        if not known or name in known or not re.fullmatch(r"/|(?:/\w+)+", name):
            continue
        near = nearest(name, known)
        yield finding(
            name,
            f"Enclave {name} is not in {keystores[0].name}: with Enforce the process ends, with Permissive it runs "
            "unsecured",
            advice=f"write {near[0]}"
            if near
            else f"create it (ros2 security create_enclave), or use one of {', '.join(known[:5])}",
            related=[note(robot.sros2.anchor_of(each), f"an enclave of {each.name}") for each in keystores[:1]],
            chain=robot.provenance.chain_to(name, f"{name} is selected"),
        )


def _not_in_policy(robot: Robot, name: Located) -> Iterator[Finding]:
    """Where the keystore is made of policies, each enclave has to be in one of them."""
    paths = [enclave.path for policy in robot.sros2.policies for enclave in policy.enclaves if enclave.path]
    first = name.split("/")[:2]
    beside = [path for path in paths if path.split("/")[:2] == first and path.count("/") > 1]
    if name in map(str, paths) or not beside or not re.fullmatch(r"(?:/\w+)+", name):
        return
    scripted = any(name in source.text for source in robot.of_kind("shell-script", "ansible"))
    if scripted or robot.mentions(re.compile(rf"\bcreate_(?:enclave|key)\b[^\n]*{re.escape(name)}(?![\w/])")):
        return
    near = nearest(name, [str(path) for path in beside])
    yield finding(
        name,
        f"No policy describes the enclave {name}: a keystore that is made of them has no keys for it, and with Enforce"
        " the process ends",
        advice=f"write {near[0]}" if near else "add it to the policy",
        related=[note(path, "a policy describes this one") for path in beside[:3]],
        severity="warning",
        confidence="medium",
    )
