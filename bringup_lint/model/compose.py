"""Compose files: services as the compose specification describes them."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.schema import Remark
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.model.yaml_node import YamlFile
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

ROS_IMAGE = regex(r"(?:^|/)(?:ros|osrf/ros|ros2|ros-core|ros-base)(?::|$)|\bros2?[-_:]|(?:^|/)osrf/")
ROS1_IMAGE = regex(r"noetic|melodic|kinetic|indigo")
ROS2_VARIABLE = regex(
    r"ROS_(?:DOMAIN_ID|SECURITY_\w+|LOCALHOST_ONLY|AUTOMATIC_DISCOVERY_RANGE|STATIC_PEERS|DISCOVERY_SERVER)|RMW_\w+"
    r"|CYCLONEDDS_URI|FAST(?:RTPS|DDS)_\w+|RCUTILS_\w+"
)
WordsOf = Callable[[Located], Iterable[Located]]
"""Splits a command line into words as a shell does."""
_DURATION = regex(r"(?<!\d)(\d+(?:\.\d+)?)(us|ms|s|m|h)")
_SECONDS = {"us": 1e-6, "ms": 1e-3, "s": 1.0, "m": 60.0, "h": 3600.0}


class Variable(NamedTuple):
    """One entry of ``environment:``; without value it is passed through from the shell."""

    name: Located
    value: Located | None
    in_list: bool = False
    """Written as ``- NAME=value``, where compose takes everything after the sign as it is."""


class Volume(NamedTuple):
    source: Located | None
    """A path of the host, or the name of a volume; None for an anonymous one."""
    target: Located | None
    read_only: bool
    where: Located
    kind: str = ""
    """What ``type:`` says; empty in the short form."""


class Device(NamedTuple):
    host: Located
    where: Located
    target: Located | None = None
    """The path in the container, where it differs."""


class Build(NamedTuple):
    context: Located | None
    dockerfile: Located | None
    target: Located | None


@dataclass(eq=False)
class Service:
    """One service, with what ``extends`` of the same file and merge keys bring."""

    name: Located
    body: Mapping
    words_of: WordsOf
    base: Service | None = None

    @property
    def source(self) -> Source:
        return self.name.span.source

    def get(self, key: str) -> Node | None:
        own = self.body.get(key)
        return own if own is not None or self.base is None else self.base.get(key)

    def key(self, key: str) -> Located | None:
        """The key itself, where it is written."""
        entry = self.body.entry(key)
        return entry[0].value if entry else self.base.key(key) if self.base else None

    def place_of(self, key: str) -> Located:
        """Where the key is written; the name of the service without it."""
        return self.key(key) or self.name

    def scalar(self, key: str) -> Located | None:
        node = self.get(key)
        return node.value if isinstance(node, Scalar) and not node.is_null else None

    def flag(self, key: str) -> bool | None:
        node = self.get(key)
        return node.boolean if isinstance(node, Scalar) else None

    def items(self, key: str) -> list[Located]:
        """The scalars of a sequence, or a single scalar; those of the base come first."""
        node = self.body.get(key)
        found = self.base.items(key) if self.base else []
        return [*found, *(scalar.value for scalar in _scalars(node))]

    @property
    def image(self) -> Located | None:
        return self.scalar("image")

    @cached_property
    def build(self) -> Build | None:
        node = self.get("build")
        if isinstance(node, Scalar) and not node.is_null:
            return Build(node.value, None, None)
        if not isinstance(node, Mapping):
            return None
        parts = (node.scalar(key) for key in ("context", "dockerfile", "target"))
        return Build(*(part.value if part else None for part in parts))

    @property
    def build_arguments(self) -> dict[str, Located | None]:
        """The ARGs that it gives to its build, with their values where these are written here."""
        node = self.get("build")
        given = node.get("args") if isinstance(node, Mapping) else None
        if isinstance(given, Mapping):
            values = ((key.value, value) for key, value in given.merged)
            return {str(name): value.value if isinstance(value, Scalar) else None for name, value in values}
        words = [word.value for word in given.scalars] if isinstance(given, Sequence) else []
        pairs = ((word, word.find("=")) for word in words)
        return {str(word.partition("=")[0]): word.part(at + 1, len(word)) if at > 0 else None for word, at in pairs}

    @property
    def inline_dockerfile(self) -> bool:
        """The Dockerfile is written in the compose file itself."""
        node = self.get("build")
        return isinstance(node, Mapping) and node.get("dockerfile_inline") is not None

    @property
    def is_whole(self) -> bool:
        """It says what it runs; else it only changes a service of another file."""
        return self.image is not None or self.build is not None

    @cached_property
    def command(self) -> tuple[Located, ...]:
        """The words of ``command``; a string is split as a shell would."""
        return self._words("command")

    @cached_property
    def entrypoint(self) -> tuple[Located, ...]:
        return self._words("entrypoint")

    def _words(self, key: str) -> tuple[Located, ...]:
        node = self.get(key)
        if isinstance(node, Sequence):
            return tuple(scalar.value for scalar in node.scalars)
        if isinstance(node, Scalar) and not node.is_null:
            return tuple(self.words_of(node.value))
        return ()

    @cached_property
    def environment(self) -> dict[str, Variable]:
        found = dict(self.base.environment) if self.base else {}
        node = self.body.get("environment")
        if isinstance(node, Mapping):
            for key, value in node.merged:
                text = value.value if isinstance(value, Scalar) and not value.is_null else None
                found[str(key.value)] = Variable(key.value, text)
        if isinstance(node, Sequence):
            for line in _scalars(node):
                name, equals, _ = line.value.partition("=")
                text = line.value.part(len(name) + 1, len(line.value)) if equals else None
                found[name] = Variable(line.value.part(0, len(name)), text, True)
        return found

    @cached_property
    def env_files(self) -> list[Located]:
        """Paths relative to the compose file."""
        node = self.get("env_file")
        paths = list(_scalars(node))
        if isinstance(node, Sequence):
            paths += [path for item in node if isinstance(item, Mapping) and (path := item.scalar("path"))]
        return [path.value for path in paths]

    @cached_property
    def devices(self) -> list[Device]:
        found = [_short_device(text) for text in self.items("devices")]
        node = self.get("devices")
        if isinstance(node, Sequence):
            for item in node:
                if isinstance(item, Mapping) and (host := item.scalar("source")):
                    target = item.scalar("target")
                    found.append(Device(host.value, host.value, target.value if target else None))
        return found

    @cached_property
    def volumes(self) -> list[Volume]:
        found = list(self.base.volumes) if self.base else []
        node = self.body.get("volumes")
        if isinstance(node, Sequence):
            for item in node:
                if isinstance(item, Scalar):
                    found.append(_short_volume(item.value))
                elif isinstance(item, Mapping) and (target := item.scalar("target")):
                    source, flag = item.scalar("source"), item.scalar("read_only")
                    read_only = bool(flag and flag.boolean)
                    place = source.value if source else None
                    kind = item.scalar("type")
                    found.append(Volume(place, target.value, read_only, target.value, str(kind.value) if kind else ""))
        return found

    @property
    def tmpfs(self) -> list[Located]:
        """The mount points, without their options."""
        return [split(text)[0] for text in self.items("tmpfs")]

    @property
    def user(self) -> Located | None:
        return self.scalar("user")

    @property
    def network_mode(self) -> Located | None:
        return self.scalar("network_mode")

    @property
    def is_on_host_network(self) -> bool:
        return self.network_mode == "host"

    @property
    def is_privileged(self) -> bool:
        return self.flag("privileged") is True

    @property
    def restart(self) -> Located | None:
        return self.scalar("restart")

    @property
    def restarts(self) -> bool:
        """A policy starts the container again."""
        if self.restart is not None:
            return self.restart != "no"
        deploy = self.get("deploy")
        return isinstance(deploy, Mapping) and deploy.get("restart_policy") is not None

    @property
    def restarts_failures(self) -> bool:
        """A policy starts the container again only after it has failed."""
        return self.restart is not None and self.restart.startswith("on-failure")

    @cached_property
    def stop_grace(self) -> float | None:
        """Seconds between the stop signal and the kill; None when it is not set or cannot be told."""
        text = self.scalar("stop_grace_period")
        if text is None or not re.fullmatch(f"(?:{_DURATION.pattern})+", text):
            return None
        return sum(float(number) * _SECONDS[unit] for number, unit in _DURATION.findall(text))

    @cached_property
    def profiles(self) -> set[str]:
        """Those that start it, any one of them; without profiles it always runs."""
        node = self.body.get("profiles")
        is_replaced = isinstance(node, Sequence) and node.tag in ("!override", "!reset")
        inherited = self.base.profiles if self.base is not None and not is_replaced else set()
        return inherited | {str(scalar.value) for scalar in _scalars(node)}

    @property
    def scripts(self) -> Iterator[Located]:
        """Everything that is run as text: the words of entrypoint and command."""
        yield from self.entrypoint
        yield from self.command

    @cached_property
    def launches(self) -> Located | None:
        """The word that holds ``ros2 launch``, or the ``launch`` after ``ros2``."""
        words = [*self.entrypoint, *self.command]
        for before, word in pairwise(words):
            if before.rpartition("/")[2] == "ros2" and word == "launch":
                return word
        return next((word for word in words if re.search(r"\bros2\s+launch\b", word)), None)

    @cached_property
    def is_ros(self) -> bool:
        """It certainly runs something of ROS 2."""
        if "ROS_MASTER_URI" in self.environment or ROS1_IMAGE.search(self.image or ""):
            return False
        if any(ROS2_VARIABLE.fullmatch(name) for name in self.environment):
            return True
        if self.image is not None and ROS_IMAGE.search(self.image):
            return True
        return any(re.search(r"(?:^|[\s/])ros2(?:\s|$)", word) for word in self.scripts)


class Beside:
    """Which of some services is the first that one choice of profiles starts together with another one. What no
    service of compose starts, None, runs with all."""

    def __init__(self, services: Iterable[Service | None]) -> None:
        self._first: dict[str | None, int] = {}
        """Profile, or None for what always runs -> the first that it starts."""
        for number, service in enumerate(services):
            for profile in _profiles(service) or (None,):
                self._first.setdefault(profile, number)

    def first(self, service: Service | None) -> int | None:
        """The place of that service among those that were given."""
        profiles = _profiles(service)
        known = (self._first.get(profile) for profile in (*profiles, None)) if profiles else self._first.values()
        return min((number for number in known if number is not None), default=None)


def _profiles(service: Service | None) -> set[str]:
    return set() if service is None else service.profiles


_GRAPHICS = regex(r"/dev/(?:dri|nvidia|nvhost|nvmap|kfd|fb\d|mali)")


def reach(service: Service) -> str:
    """What root in the container reaches on the host, as the end of a sentence; empty for an ordinary container."""
    if service.is_privileged:
        return ", and is privileged: that is root on the host"
    if any(not _GRAPHICS.match(device.host) for device in service.devices) or service.items("device_cgroup_rules"):
        return ", and has devices of the robot: whoever breaks into a node controls them"
    return ""


@dataclass(eq=False)
class ComposeFile:
    source: Source
    yaml: YamlFile
    services: list[Service] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    """What is no valid YAML, and keys that appear twice."""
    remarks: list[Remark] = field(default_factory=list)
    """What docker compose has against the content."""

    def service(self, name: str) -> Service | None:
        return next((service for service in self.services if service.name == name), None)


def split(text: Located) -> list[Located]:
    """The parts between colons, those inside ``${NAME:-default}`` left alone."""
    parts, start, depth = [], 0, 0
    for at, char in enumerate(text):
        if text.startswith("${", at):
            depth += 1
        elif char == "}" and depth:
            depth -= 1
        elif char == ":" and not depth:
            parts.append(text.part(start, at))
            start = at + 1
    return [*parts, text.part(start, len(text))]


def is_variable(text: str) -> bool:
    """Whether compose still puts something in: ``$NAME`` or ``${NAME}``, but not ``$$``."""
    return "$" in text.replace("$$", "")


def _scalars(node: Node | None) -> Iterator[Scalar]:
    if isinstance(node, Sequence):
        yield from node.scalars
    elif isinstance(node, Scalar) and not node.is_null:
        yield node


def _short_device(text: Located) -> Device:
    host, *others = split(text)
    return Device(host, text, others[0] if others else None)


def _short_volume(text: Located) -> Volume:
    parts = split(text)
    if len(parts) == 1:
        return Volume(None, parts[0], False, text)
    modes = parts[2].split(",") if len(parts) > 2 else []
    return Volume(parts[0], parts[1], "ro" in modes, text)
