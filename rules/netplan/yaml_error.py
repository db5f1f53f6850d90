"""A netplan file is not valid YAML.

## What it finds
Anything that the YAML parser rejects: a tab in the indentation, a missing space, unbalanced brackets.
Templates are not checked.

## Why it matters on a robot
One broken line in one file stops netplan for all files. `netplan apply` changes nothing, and older versions
bring the robot up without a network. Newer versions skip the file at boot without a message.

## Bad
```yaml
network:
  version: 2
  ethernets:
        eth0:          # a tab
      dhcp4: true
```

## Good
```yaml
network:
  version: 2
  ethernets:
    eth0:
      dhcp4: true
```

## When to ignore it
If the file is a template that a tool fills in, and that does not look like one. Then exclude it from the
check.

## References
- netplan-generate(8)
- YAML 1.2.2, section 6.1, "Indentation Spaces"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.yaml import YamlCode


@rule(
    "error",
    symptoms=[
        "Invalid YAML: tabs are not allowed for indent",
        "Invalid YAML: inconsistent indentation",
        "Invalid YAML:",
        "system-generators/netplan failed with error code",
    ],
)
def yaml_error(robot: Robot) -> Iterator[Finding]:
    for file in robot.netplan.files:
        if file.source.template:
            continue
        for problem in file.yaml.problems[:1]:
            if problem.code == YamlCode.TAB:
                message = "Tabs are not allowed in YAML: netplan generates nothing"
                advice = "indent with spaces"
            else:
                message = f"This is not valid YAML ({problem.detail}): netplan generates nothing"
                advice = "correct the indentation, quotes or brackets around this place"
            yield finding(problem.where, message, advice=advice)
