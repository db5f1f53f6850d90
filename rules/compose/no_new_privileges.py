"""A container can gain privileges.

## What it finds
A service whose `security_opt` does not contain `no-new-privileges:true`. Privileged services are reported by
`compose/privileged`.

## Why it matters on a robot
A setuid program in the image makes an intruder root in the container.

## Bad
```yaml
driver:
  image: robot/driver:1.2
```

## Good
```yaml
driver:
  image: robot/driver:1.2
  security_opt: ["no-new-privileges:true"]
```

## When to ignore it
When a program in the container needs setuid, such as `sudo` or `ping` without capabilities.

## References
- robotics-security guide, container hardening
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.yaml import first_key


@rule("info", fix="unsafe", silent="Docker does not report what a container may do")
def no_new_privileges(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.unprivileged_services:
        if not any(
            item.replace("=", ":") in ("no-new-privileges:true", "no-new-privileges")
            for item in service.items("security_opt")
        ):
            yield finding(
                service.name,
                f"Service '{service.name}' can gain privileges through setuid programs",
                advice='add security_opt: ["no-new-privileges:true"]',
                fix=fix("add no-new-privileges", first_key(service.body, 'security_opt: ["no-new-privileges:true"]'))
                if service.key("security_opt") is None
                else None,
            )
