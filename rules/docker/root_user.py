"""The container runs as root.

## What it finds
A last stage with `USER root` as its last USER, or without USER on an image that certainly runs as root (the
official ROS, Ubuntu, Debian and Python images). Not checked: builder stages, images that other Dockerfiles of the tree
build on, images that start systemd, images that only build or test something (`CMD ["make"]`), and images whose
services in compose files all set `user:`. Silent if the Dockerfile or the entry script mentions gosu, su-exec, setpriv,
runuser or fixuid, which drop privileges, or if the entry script is that of a base image that is not known.

Images of a tree that run as root for the same purpose are one finding.

It is info for images that a robot hardly runs by themselves: without USER, CMD and ENTRYPOINT; a shell in which
somebody works or logs in with ssh, also as ENTRYPOINT of an image that no service runs; an image whose command is a
shell, and whose services in compose files say nothing but how it is built; one without ENTRYPOINT whose services only
keep a shell open (`command: bash`, `tty: true`), in which nothing of the tree but a shell is run (`docker exec -it
ferry bash`); a builder, a simulator or a demonstration; a Dockerfile that nothing builds while another one in its
place is built; and an image that copies nothing, builds nothing and has nothing of ROS: it runs a program of the
distribution.

## Why it matters on a robot
An intruder in one node is root in the container. If the host uses another user, Fast DDS's shared memory cannot be
opened from both sides: topics are listed, but no data arrives.

## Bad
```dockerfile
FROM ros:jazzy
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## Good
```dockerfile
FROM ros:jazzy
RUN useradd --system robot
USER robot
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## When to ignore it
When every deployment sets `user:` or `--user` for this image.

## References
- robotics-security guide, container hardening
- CWE-250
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from bringup_lint.api import Finding
from bringup_lint.api import Purpose
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.compose import reach
from bringup_lint.api.docker import Instruction
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import can_be_pulled
from bringup_lint.api.docker import holds_ros
from bringup_lint.api.docker import image_user
from bringup_lint.api.docker import is_deployed
from bringup_lint.api.docker import is_entered_by_hand
from bringup_lint.api.docker import last_user
from bringup_lint.api.shell import program_name

DROPS = regex(r"\b(?:gosu|su-exec|setpriv|runuser|fixuid)\b")
LOGINS = regex(r"\b(?:openssh-server|sshd|sysvinit|s6-overlay)\b")
"""What needs root to serve logins, or to start services as an init system."""
BUILD = regex(
    r"""\[?\s*["']?(?:/usr/bin/)?(?:make(?!["',\s\[\]]{1,9}(?:run|start|launch|up)\b)|cmake|ninja|colcon|catkin|bloom-generate|dpkg-buildpackage|debuild|bitbake|west"""
    r"""|idf\.py|pio|platformio|arduino-cli|cargo(?!["',\s\[\]]{1,9}run\b)|pytest|ctest|mkdocs|sphinx-build)(?:["']|\s|$)"""
)
"""A command line, or the start of its list, that builds or tests something and then ends."""
DAEMONS = regex(r"(?:^|[\s\"'/\[])(?:mosquitto|nginx|apache2|httpd|chronyd|avahi-daemon)(?=[\s\"',\]]|$)")
"""Daemons that root starts and that become another user by themselves."""
DISTRIBUTION = regex(r"(?:ubuntu|debian|alpine)(?::|$)")
PACKAGES = regex(r"\b(?:apt-get|apt|apk)\b")
OWN = regex(r"\bros|colcon|catkin|\bgit\b|curl|wget|\bpip3?\b|npm|cargo|make", re.I)
"""What brings ROS, or programs of other people, into an image."""
LEAVES = regex(
    r"(?:^|[\s\"'/\[])(?:su[\s\"',]{1,8}(?:-[\w-]{0,20}[\s\"',]{1,8}){0,4}(?!root\b)[a-z$]"
    r"|sudo[\s\"',]{1,8}(?:-\S{1,20}[\s\"',]{1,8}){0,4}(?:-u|--user)\b(?![\s\"',=]{1,8}root\b)|chroot[\s\"',]{1,8}--userspec\b)"
)
"""A command that another user runs."""
HOME_OF_ROOT = regex(r"(?<![\w./-])/root(?![\w.-])", hints="/root")
REMOVED = regex(r"\brm[ \t](?:\\\n|[^\n;&|]){0,900}", hints="rm")
EXECUTES = regex(
    r"\b(?:docker|podman|nerdctl|compose)\b[^\n;&|]{0,200}[ \t\"',]exec[\s\"',]"
    r"(?![^\n;&|<]{0,200}[\s\"',](?:[\w/]{0,20}/)?(?:ba|z|da)?sh[\"']?[ \t]*(?:\Z|[\n;&)\]}]))"
    r"|\|[ \t]*(?:sudo[ \t]+)?(?:docker|podman|nerdctl)[^\n;&|]{0,200}[ \t]exec[ \t]|[\"']exec[\"'],|\bexec_run\(",
    hints="exec",
)
"""What runs more than a shell in a container that is there."""
MOST = 20
OF_BUILD = frozenset({"build", "image", "profiles", "platform", "container_name", "extends"})
"""Keys of a service that is there to build an image."""
SHELLS = ("bash", "sh", "dash", "zsh")
SYSTEMD = regex(r"/(?:s?bin/init|lib/systemd/systemd)\b")


class AsRoot(NamedTuple):
    """An image that runs as root."""

    stage: Stage
    services: list[Service]
    """Those that run it and set no user."""
    lowered: bool
    """Whether a robot hardly runs it by itself."""

    @property
    def far(self) -> str:
        """What an intruder reaches, with its comma."""
        return max((reach(service) for service in self.services), key=len, default="")

    @property
    def is_info(self) -> bool:
        only_built = bool(self.services) and all(map(_only_builds, self.services)) and _ends_in_shell(self.stage)
        return (
            self.lowered or only_built or (last_user(self.stage) is None and not (self.services or _runs(self.stage)))
        )


@rule("warning", silent="root may do everything, so nothing fails", tags=["CWE-250"])
def root_user(robot: Robot) -> Iterator[Finding]:
    alike: dict[Purpose, list[AsRoot]] = {}
    for image in _found(robot):
        if image.is_info:
            yield _finding(image)
        else:
            alike.setdefault(robot.purpose(image.stage.start.keyword), []).append(image)
    for images in alike.values():
        images.sort(key=lambda image: len(image.far), reverse=True)
        yield _finding(*images)


def _found(robot: Robot) -> Iterator[AsRoot]:
    bases = {id(stage.base) for file in robot.dockerfiles for stage in file.stages}
    for file in robot.dockerfiles:
        stage = file.final
        if stage is None or DROPS.search(file.source.said) or _needs_root(stage) or id(stage) in bases:
            continue
        if _builds(stage):
            continue
        users = [service for each in file.stages for service in robot.compose.users(each)]
        if (users and all(service.user is not None for service in users)) or image_user(stage) != "root":
            continue
        if not _drops_in_script(robot, stage) and not _entrypoint_is_unknown(robot, stage):
            services = [service for service in users if service.user is None]
            of_robot = is_deployed(robot.compose, file) and (holds_ros(stage) or any(map(reach, services)))
            lowered = (
                not of_robot or _serves_logins(stage) or _runs_packaged(stage) or _is_entered(robot, stage, services)
            )
            yield AsRoot(stage, services, lowered)


def _finding(image: AsRoot, *others: AsRoot) -> Finding:
    user = last_user(image.stage)
    related = [note(service.name, "runs this image") for service in image.services]
    related += [note(other.stage.start.keyword, "so does this image") for other in others[:MOST]]
    severity = "info" if image.is_info else None
    if user is not None:
        message = f"The container runs as root{image.far}"
        return finding(user, message, advice=_advice(image), related=related, severity=severity)
    why = f"{image.stage.origin} sets no USER, and neither does this file"
    return finding(
        image.stage.start.keyword,
        f"The container runs as root{image.far}{';' if image.far else ':'} {why}",
        advice=_advice(image),
        related=related,
        severity=severity,
    )


def _advice(image: AsRoot) -> str:
    """How the container does without root: what it still needs then has to be open to the user."""
    groups = " in the groups of its devices (group_add: [dialout])" if image.far else ""
    steps = (each for stage in image.stage.chain for each in stage.instructions)
    in_home = any(HOME_OF_ROOT.search(_kept(each)) for each in steps)
    moved = ", move what it runs and reads out of /root, which only root may enter" if in_home else ""
    return f"create an unprivileged user{groups}{moved}, and end the file with USER"


def _kept(step: Instruction) -> str:
    """A step without what it removes, and without the paths of another image from which it copies."""
    if any(flag.startswith("--from=") for flag in step.flags):
        return (step.exec_form or str(step.value).split())[-1]
    return REMOVED.sub("", step.value)


def _only_builds(service: Service) -> bool:
    return all(key.value in OF_BUILD for key, _ in service.body.merged)


def _ends_in_shell(stage: Stage) -> bool:
    command = stage.last("CMD")
    return command is None or program_name(str(command.exec_form[-1] if command.exec_form else command.value)) in SHELLS


def _runs(stage: Stage) -> bool:
    """Whether the image says what it runs; else it is a base, or a place to work in."""
    entrypoint = stage.last("ENTRYPOINT")
    if stage.last("CMD") is not None or entrypoint is None:
        return stage.last("CMD") is not None
    words = entrypoint.exec_form or str(entrypoint.value).split()
    return len(words) != 1 or program_name(words[0]) not in SHELLS


def _builds(stage: Stage) -> bool:
    """Whether what the image runs is a build: its container ends with the result and never is on the robot."""
    starts = [each.value for each in (stage.last("ENTRYPOINT"), stage.last("CMD")) if each is not None]
    return bool(starts) and any(BUILD.match(line) for line in (" ".join(starts), starts[-1]))


def _needs_root(stage: Stage) -> bool:
    """Whether the first process is systemd, a daemon that drops root itself, or what starts the robot's as a user."""
    starts = (stage.last("ENTRYPOINT"), stage.last("CMD"))
    return any(each is not None and known.search(each.value) for each in starts for known in (SYSTEMD, DAEMONS, LEAVES))


def _serves_logins(stage: Stage) -> bool:
    """Whether the image holds an ssh daemon or an init system, and does not start ROS itself."""
    starts = (stage.last("ENTRYPOINT"), stage.last("CMD"))
    if any(each is not None and "ros2" in each.value for each in starts):
        return False
    return any(LOGINS.search(each.value) for each in stage.instructions)


def _runs_packaged(stage: Stage) -> bool:
    """Whether an image takes nothing but packages of a distribution, none of them of ROS."""
    each = [instruction for one in stage.chain for instruction in one.instructions]
    if any(instruction.name in ("COPY", "ADD") for instruction in each):
        return False
    text = " ".join(str(instruction.value) for instruction in each)
    is_plain = DISTRIBUTION.match(stage.origin) is not None
    return is_plain and PACKAGES.search(text) is not None and OWN.search(text) is None


def _is_entered(robot: Robot, stage: Stage, services: list[Service]) -> bool:
    """Whether the container is open for somebody, and nothing of the tree starts anything in it."""
    if stage.last("ENTRYPOINT") is not None or not services or not all(map(is_entered_by_hand, services)):
        return False
    return not robot.mentions(EXECUTES)


def _entrypoint_is_unknown(robot: Robot, stage: Stage) -> bool:
    """Whether the image below, which is another one of the project's own, may start with a script that drops root."""
    if stage.last("ENTRYPOINT") is not None:
        return False
    return "$" in stage.origin or robot.compose.images.is_built(stage.origin) or not can_be_pulled(stage.origin)


def _drops_in_script(robot: Robot, stage: Stage) -> bool:
    runners = robot.runners.of_stage(stage)
    return any(DROPS.search(text) for runner in runners for line in runner.lines for text in line.texts)
