"""Which ROS distribution and systemd version the robot runs, and who says so."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.facts.ros import distros
from bringup_lint.facts.systemd.directives import NEWEST
from bringup_lint.pattern import regex
from bringup_lint.source import Source

SYSTEMD_OF_OS = {
    ("ubuntu", "20.04"): 245,
    ("ubuntu", "22.04"): 249,
    ("ubuntu", "24.04"): 255,
    ("debian", "12"): 252,
    ("debian", "13"): 257,
}
"""The systemd of a release, by ID and VERSION_ID of os-release(5)."""

DEFAULT_SYSTEMD = 249

_DISTROS = distros.supported()
_DISTRO = "|".join(_DISTROS)
_MENTIONS = regex(
    rf"(?=[/Rri])(?:/opt/ros/({_DISTRO})\b|(?<![A-Za-z0-9])ROS_DISTRO[=:]\s*[\"']?({_DISTRO})\b"
    rf"|\bros:({_DISTRO})\b|\bros-({_DISTRO})-"
    rf"|\bimage:\s*[\"']?[\w./-]+:({_DISTRO})(?=[-.\s\"'@])"
    rf"|/(?<=[\w./]/)[\w.-]*(?:l4t|ros2?|focal|jammy|noble)[\w.]*-({_DISTRO})(?=[:@\s\"'-]))"
)
"""The look at the first character keeps the search from trying each way at each place."""


def _named(text: str) -> Iterator[str]:
    """Each place where a file names a distribution. Most files hold no word of one, which is found out much sooner."""
    if any(distro in text for distro in _DISTROS):
        for match in _MENTIONS.finditer(text):
            yield from (group for group in match.groups() if group)


def mentions_of(distro: str) -> re.Pattern[str]:
    """What names a distribution, outside of comments."""
    name = re.escape(distro)
    before = r"(?m)^(?![ \t]*(?:#|//))[^#\n]*?"
    words = rf"/opt/ros/{name}\b|(?<![A-Za-z0-9])ROS_DISTRO[=:]\s*[\"']?{name}\b|\bros:{name}\b|\bros-{name}-"
    return regex(f"{before}(?P<name>{words})")


@dataclass(frozen=True)
class Target:
    """What the robot runs. Either may be unknown; ``why`` says where it was read."""

    ros: str | None
    ros_why: str
    systemd: int
    systemd_why: str
    systemd_known: bool
    named: frozenset[str]
    """Every distribution that the configuration or the tree names."""

    @property
    def ros_named(self) -> bool:
        """Whether the configuration or the tree names a distribution, be it several."""
        return bool(self.named)

    @property
    def newest(self) -> int:
        """The systemd to judge by when only what no release accepts is to be found."""
        return self.systemd if self.systemd_known else NEWEST


def find_target(sources: Iterable[Source], ros: str | None, systemd: int | None) -> Target:
    """The configured target, else what the tree says about itself, else the defaults."""
    sources = list(sources)
    named: frozenset[str]
    ros_why, named = ("configured", frozenset({ros})) if ros else ("not known", frozenset())
    if ros is None:
        ros, ros_why, named = _mentioned_ros(sources)
    if systemd is not None:
        return Target(ros, ros_why, systemd, "configured", True, named)
    release = _os_release(sources)
    if release:
        return Target(ros, ros_why, *release, True, named)
    if ros:
        return Target(ros, ros_why, distros.systemd_of(ros), f"the systemd of ROS {ros}'s Ubuntu", True, named)
    return Target(None, ros_why, DEFAULT_SYSTEMD, "assumed: Ubuntu 22.04", False, named)


def _mentioned_ros(sources: Iterable[Source]) -> tuple[str | None, str, frozenset[str]]:
    mentions: dict[str, Source] = {}
    for source in sources:
        if not source.judged or source.kind in ("python-node", "cpp-node"):
            continue
        for name in _named(source.text):
            mentions.setdefault(name, source)
    if len(mentions) == 1:
        (ros, source) = next(iter(mentions.items()))
        return ros, f"named in {source.name}", frozenset(mentions)
    if mentions:
        return None, f"not known: the tree names {', '.join(sorted(mentions))}", frozenset(mentions)
    return None, "not known", frozenset()


def _os_release(sources: Iterable[Source]) -> tuple[int, str] | None:
    for source in sources:
        if source.kind != "os-release":
            continue
        pairs = (line.partition("=") for line in source.text.splitlines())
        fields = {key: value.strip("\"'") for key, _, value in pairs}
        version = SYSTEMD_OF_OS.get((fields.get("ID", ""), fields.get("VERSION_ID", "")))
        if version:
            return version, f"the systemd of {fields.get('PRETTY_NAME') or source.name}"
    return None
