"""A container sets a kernel parameter that it cannot write.

## What it finds
`sysctl -w` and `sysctl -p` in the command or entry script of a compose service that is not privileged.

## Why it matters on a robot
Docker mounts `/proc/sys` read-only. The command fails with "Read-only file system", and the buffers of the network
stack stay as they are: large messages such as images are lost. With `set -e` the container ends there.

## Bad
```sh
# entrypoint.sh
sysctl -w net.core.rmem_max=16777216
```

## Good
```sh
# on the host
echo 'net.core.rmem_max=16777216' | sudo tee /etc/sysctl.d/60-dds.conf
```

## When to ignore it
When the container is started with `--privileged` elsewhere.

## References
- https://docs.docker.com/reference/compose-file/services/#sysctls
- sysctl.d(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import Runner
from bringup_lint.api.shell import unwrapped

OPTIONS = ("-w", "--write", "-p", "--load", "--system")


@rule(
    "warning",
    symptoms=[
        "sysctl: setting key",
        "Read-only file system",
        "OCI runtime create failed: * write sysctl key",
    ],
)
def sysctl_read_only(robot: Robot) -> Iterator[Finding]:
    whole = list(robot.compose.whole_services)
    found: dict[object, tuple[Located, list[Runner]]] = {}
    for runner in robot.runners.all:
        service = runner.service
        if service is None or service not in whole or _may_write(service):
            continue
        for command in runner.commands:
            words = unwrapped(command.words)
            if words and words[0].rpartition("/")[2] == "sysctl" and any(word in OPTIONS for word in words[1:]):
                found.setdefault(words[0].span, (words[0], []))[1].append(runner)
    for place, runners in found.values():
        yield finding(
            place,
            f"/proc/sys is read-only in {runners[0].name}: this sysctl has no effect",
            advice="set it on the host, in a file in /etc/sysctl.d",
            related=[note(runner.where, "not privileged") for runner in runners],
        )


def _may_write(service: Service) -> bool:
    options = map(str, service.items("security_opt"))
    return service.is_privileged or any("systempaths" in option for option in options)
