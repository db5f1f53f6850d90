"""A variable of ROS or its middleware is misspelt.

## What it finds
A variable that nobody reads, whose name is that of a known one but for an underscore or a letter, and whose value is
what the known one takes: the file of a DDS configuration, a number for a domain, the name of a middleware. Whatever
the value, where one letter is left out, there twice, exchanged with the next or the one beside it on the keyboard.
Silent if something else in the tree reads the variable by this name. Also a variable that is made up from the name of a
middleware and of what it is to do, such as `RMW_FASTRTPS_USE_SHM`; an info beside a profile of Fast DDS. And names that
sound right, such as `ROS_SECURITY_ENCLAVE` for `ROS_SECURITY_ENCLAVE_OVERRIDE`.

## Why it matters on a robot
The setting has no effect, and nothing says so: the middleware runs with its defaults, on every interface and with
multicast, or the robot is in domain 0 with everybody else.

## Bad
```yaml
environment:
  CYCLONE_DDS_URI: file:///config/cyclonedds.xml
```

## Good
```yaml
environment:
  CYCLONEDDS_URI: file:///config/cyclonedds.xml
```

## When to ignore it
When a program outside of the tree reads the variable by this name.

## References
- https://docs.ros.org/en/rolling/How-To-Guides/DDS-tuning.html
- https://fast-dds.docs.eprosima.com/en/latest/fastdds/env_vars/env_vars.html
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.environment import Setting
from bringup_lint.api.ros import misspelt
from bringup_lint.api.ros import variables
from bringup_lint.api.spelling import nearest

VALUES = {
    "domain": regex(r"\d{1,3}|\$\{?\w+(?::?-\d{1,3}\}|\}?)"),
    "rmw": regex(r"rmw_\w+"),
    "file": regex(r"(?:file://)?[^\s<]+\.(?:xml|json5?|env)|<\S.*", re.S),
}

OF_MIDDLEWARE = regex(r"(?:RMW_(?:FASTRTPS|FASTDDS|CYCLONEDDS)|FASTRTPS|FASTDDS)_\w+")
WISHED = frozenset("USE ENABLE DISABLE SHM SHARED TRANSPORT TRANSPORTS DISCOVERY INTERFACE".split())
"""Words for settings that a middleware has, but not as a variable."""
PROFILES = "_DEFAULT_PROFILES_FILE"
"""Beside a profile, which says the same in earnest, a name that nothing reads does no harm."""
INSTEAD = (
    (regex(r"SHM|SHARED|TRANSPORT"), "set FASTDDS_BUILTIN_TRANSPORTS, or a profile by FASTRTPS_DEFAULT_PROFILES_FILE"),
    (regex(r"CYCLONE"), "write it in the file of CYCLONEDDS_URI"),
    (regex(r""), "write it in the profile of FASTRTPS_DEFAULT_PROFILES_FILE"),
)


NEVER = {
    "ROS_SECURITY_ENCLAVE": "ROS_SECURITY_ENCLAVE_OVERRIDE",
    "ROS_SECURITY_KEYSTORE_PATH": "ROS_SECURITY_KEYSTORE",
    "ROS_SECURITY_ENABLED": "ROS_SECURITY_ENABLE",
    "ROS_DOMAIN": "ROS_DOMAIN_ID",
    "ROS2_DOMAIN_ID": "ROS_DOMAIN_ID",
    "ROS_RMW_IMPLEMENTATION": "RMW_IMPLEMENTATION",
    "ROS_DISCOVERY_RANGE": "ROS_AUTOMATIC_DISCOVERY_RANGE",
    "ROS_DISCOVERY_SERVERS": "ROS_DISCOVERY_SERVER",
    "FASTDDS_DISCOVERY_SERVER": "ROS_DISCOVERY_SERVER",
    "FASTRTPS_URI": "FASTRTPS_DEFAULT_PROFILES_FILE",
    "CYCLONEDDS_CONFIG": "CYCLONEDDS_URI",
}
"""Names that sound right, have never been read by a release, and what they are taken for."""


@rule("error", silent="no program looks at the misspelt name")
def misspelt_variable(robot: Robot) -> Iterator[Finding]:
    strange: dict[tuple[str, str], list[Setting]] = {}
    for setting in robot.ros.settings:
        if setting.name not in variables():
            strange.setdefault((setting.name, setting.value.span.path), []).append(setting)
    for (name, _), settings in strange.items():
        meant = _meant(name)
        fitting = [each for each in settings if meant and VALUES[variables()[meant]].fullmatch(each.value.strip("\"'"))]
        slip = misspelt(name)
        if slip and not _is_read(robot, name):
            yield _unread(settings, f"write {slip}")
        elif fitting and not _is_read(robot, name):
            yield _unread(fitting, f"write {meant}")
        elif name in NEVER and not _is_read(robot, name):
            yield _unread(settings, f"write {NEVER[name]}")
        elif _is_made_up(name) and not _is_read(robot, name):
            advice = next(advice for word, advice in INSTEAD if word.search(name))
            yield _unread(settings, advice, "info" if PROFILES in settings[0].value.span.source.text else "error")


def _is_made_up(name: str) -> bool:
    return OF_MIDDLEWARE.fullmatch(name) is not None and not WISHED.isdisjoint(name.split("_"))


def _unread(settings: list[Setting], advice: str, severity: str = "error") -> Finding:
    first, *others = settings
    return finding(
        first.value,
        f"Nothing reads {first.name}: this setting has no effect",
        advice=advice,
        related=[note(other.value, "the same name") for other in others],
        severity=severity,
    )


def _meant(name: str) -> str | None:
    """The one variable with a typed value that a name is taken for."""
    typed = [known for known, value in variables().items() if value]
    plain = name.replace("_", "")
    same = [known for known in typed if known.replace("_", "") == plain]
    near = same or [known for known in nearest(name, variables()) if known in typed]
    return near[0] if len(near) == 1 else None


def _is_read(robot: Robot, name: str) -> bool:
    """Whether something of the tree asks for a variable of this name."""
    written = re.escape(name)
    in_code = rf"(?:get(?:env)?\(|environ\[|(?<!SetEnvironment)Variable\(|\bname=)\s*[\"']{written}[\"']"
    asks = re.compile(rf"\$\{{?{written}\b|\(env {written}\b|{in_code}")
    return robot.files.mentions(asks)
