"""A service chooses GPUs and gets none.

## What it finds
`NVIDIA_VISIBLE_DEVICES` or `NVIDIA_DRIVER_CAPABILITIES` in the environment of a service without `runtime`, `gpus`,
`deploy` and devices of NVIDIA, where another service of the same file has `runtime: nvidia` or `gpus`. Silent where
the tree makes nvidia the default runtime of Docker, or one of its pages tells to, for the values `void` and `none` and
for variables, where the service has its variables in common with another one, and where another compose file gives GPUs
to a service of this name.

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

from collections import Counter
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
ELSEWHERE = (*GIVES, "devices")
DEFAULT = regex(r"default[-_]runtime|set-as-default", hints="default-runtime default_runtime set-as-default")
SETTINGS = regex(r"(?:^|/)(?:daemon\.json|README[^/]*|[^/]*\.(?:md|rst|adoc|txt))$")
MOST = 200_000


@rule(
    "info",
    confidence="medium",
    symptoms=["CUDA driver version is insufficient", "no CUDA-capable device is detected"],
)
def gpu_not_given(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        services = [] if file.source.template else [each for each in file.services if each.is_whole]
        given = next((place for each in services if (place := _given(each)) is not None), None)
        lacking = [] if given is None else list(_lacking(robot, file.services, services))
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


def _lacking(robot: Robot, every: list[Service], services: list[Service]) -> Iterator[tuple[Service, Located]]:
    """Services that choose GPUs and get none, each with the variable that chooses, which is its own."""
    places = Counter(place.span for each in every for place in _variables(each))
    for service in services:
        name = _asks(service)
        if name is not None and places[name.span] == 1 and not robot.compose.is_set_elsewhere(service, *ELSEWHERE):
            yield service, name


def _variables(service: Service) -> Iterator[Located]:
    variables = (service.environment.get(name) for name in VARIABLES)
    return (each.name for each in variables if each is not None and _chooses(str(each.value or "")))


def _chooses(value: str) -> bool:
    return "$" not in value and value not in NONE


def _asks(service: Service) -> Located | None:
    """The variable with which a service chooses GPUs that it does not get."""
    if any(service.get(key) is not None for key in GIVES) or any("nvidia" in each.host for each in service.devices):
        return None
    return next(_variables(service), None)


def _is_default(robot: Robot) -> bool:
    return robot.mentions(DEFAULT) or robot.tree.says(SETTINGS, MOST, DEFAULT)
