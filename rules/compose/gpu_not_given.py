"""A service chooses GPUs and gets none.

## What it finds
`NVIDIA_VISIBLE_DEVICES` or `NVIDIA_DRIVER_CAPABILITIES` in the environment of a service without `runtime`, `gpus`,
`deploy` and devices of NVIDIA, where another service of the same file has `runtime: nvidia` or `gpus`. Silent where
the tree makes nvidia the default runtime of Docker, and for the values `void` and `none`.

## Why it matters on a robot
Only the runtime of NVIDIA reads these variables. With the usual runtime the container has no GPU: the detector runs on
the processor, ten times slower, or does not start.

## Bad
```yaml
camera:
  image: rover/camera:1.2
  runtime: nvidia
detector:
  image: rover/detector:1.2
  environment: [NVIDIA_VISIBLE_DEVICES=all]
```

## Good
```yaml
camera:
  image: rover/camera:1.2
  runtime: nvidia
detector:
  image: rover/detector:1.2
  runtime: nvidia
  environment: [NVIDIA_VISIBLE_DEVICES=all]
```

## When to ignore it
When `/etc/docker/daemon.json` of the robot makes nvidia the default runtime.

## References
- https://docs.nvidia.com/datacenter/cloud-native/container-toolkit/latest/docker-specialized.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service

VARIABLES = ("NVIDIA_VISIBLE_DEVICES", "NVIDIA_DRIVER_CAPABILITIES")
NONE = ("void", "none", "")
GIVES = ("runtime", "gpus", "deploy")
DEFAULT = regex(r"default[-_]runtime", hints="default-runtime default_runtime")
SETTINGS = regex(r"(?:^|/)(?:daemon\.json|README[^/]*)$")
MOST = 200_000


@rule(
    "warning",
    confidence="medium",
    symptoms=["CUDA driver version is insufficient", "no CUDA-capable device is detected"],
)
def gpu_not_given(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        services = [] if file.source.template else [each for each in file.services if each.is_whole]
        given = next((place for each in services if (place := _given(each)) is not None), None)
        lacking = [] if given is None else [(each, name) for each in services if (name := _asks(each)) is not None]
        if given is None or not lacking or _is_default(robot):
            continue
        for service, name in lacking:
            yield finding(
                name,
                f"'{service.name}' gets no GPU: only the runtime of NVIDIA reads {name}",
                advice="write runtime: nvidia",
                related=[note(given, "the GPUs are given to this service")],
            )


def _given(service: Service) -> Located | None:
    """Where a service gets the GPUs."""
    runtime = service.scalar("runtime")
    if runtime == "nvidia":
        return runtime
    return service.key("gpus")


def _asks(service: Service) -> Located | None:
    """The variable with which a service chooses GPUs that it does not get."""
    if any(service.get(key) is not None for key in GIVES) or any("nvidia" in each.host for each in service.devices):
        return None
    variables = (service.environment.get(name) for name in VARIABLES)
    return next((each.name for each in variables if each is not None and str(each.value or "") not in NONE), None)


def _is_default(robot: Robot) -> bool:
    return robot.mentions(DEFAULT) or robot.tree.says(SETTINGS, MOST, DEFAULT)
