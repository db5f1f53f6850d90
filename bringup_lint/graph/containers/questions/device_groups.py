"""Whether the user of a container may open the devices that its service hands over: docker keeps owner and mode.

Source: 50-udev-default.rules of Debian and Ubuntu, and the rules of i2c-tools and Raspberry Pi OS for the groups.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.base_images import is_plain
from bringup_lint.graph.containers.base_images import ubuntu_codename
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.dockerfile_variables import last_user
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.model.compose import Device
    from bringup_lint.model.compose import Service
    from bringup_lint.model.dockerfile import Stage
    from bringup_lint.source import Located

_GROUPS = (
    (regex(r"/dev/(?:tty(?:USB|ACM|S|AMA|THS)\d+|serial/by-(?:id|path)/.+|serial\d)"), "dialout", "20"),
    (regex(r"/dev/(?:video\d+|v4l/by-(?:id|path)/.+)"), "video", "44"),
    (regex(r"/dev/snd(?:/.*)?"), "audio", "29"),
    (regex(r"/dev/input(?:/.*)?"), "input", ""),
    (regex(r"/dev/i2c-\d+"), "i2c", ""),
    (regex(r"/dev/spidev[\d.]+"), "spi", ""),
    (regex(r"/dev/gpio(?:chip\d+|mem\d*)"), "gpio", ""),
)
"""Device nodes that only root and a group may open, with the id of the group where Debian and Ubuntu fix it."""
_OPENED = regex(
    r"MODE:?=\"0?[67][67][67]\"|TAG\+=\"uaccess\"|OWNER:?=\"|GROUP:?=\"(?!(?:dialout|video|audio|input|i2c|spi|gpio)\")"
    r"|\b(?:chmod|setfacl|chown)\b[^\n;&]{0,200}/dev/"
)


_FIRST_USER = ("ubuntu", "1000")
"""Since 24.04, images of Ubuntu, and so those of ROS, have this user, with these groups."""
_GROUPS_OF_FIRST_USER = ("dialout", "audio", "video")
_WITHOUT_USER = ("bionic", "focal", "jammy")


class Closed(NamedTuple):
    """A device that the user of a service may not open."""

    service: Service
    device: Device
    group: str
    user: Located


def closed_devices(files: Files, compose: Compose) -> Iterator[Closed]:
    """The first such device of each service."""
    if any(
        _OPENED.search(source.text)
        for source in files.of_kind("udev-rules", "shell-script", "ansible", "systemd-unit", "compose", "dockerfile")
    ):
        return
    for service in compose.whole_services:
        stage = compose.stage(service)
        user = service.user or (last_user(stage) if stage is not None else None)
        if user is None or service.is_privileged or not _is_known(user):
            continue
        for device in service.devices:
            found = next(((name, number) for node, name, number in _GROUPS if node.fullmatch(device.host)), None)
            if found is not None and not _is_member(service, stage, user, *found):
                yield Closed(service, device, found[0], user)
                break


def _is_known(user: str) -> bool:
    """Whether the user is not root, and no variable hides it."""
    name, _, group = user.partition(":")
    return "$" not in user and name not in ("", "root", "0") and group not in ("root", "0")


def _is_member(service: Service, stage: Stage | None, user: str, group: str, number: str) -> bool:
    """Whether the process may have a group. Docker takes the groups of the image's /etc/group for a user, and none of
    them where ``user:`` names a group."""
    added = [str(item) for item in service.items("group_add")]
    if any(item in (group, number) or not item.isalpha() for item in added):
        return True
    own = user.partition(":")[2]
    if own:
        return own in (group, number) or (
            own.isdecimal() and len(own) < 10 and not number and not 1000 <= int(own) < 60000
        )
    if stage is None or not is_plain(stage.origin):
        return True
    if user in _FIRST_USER and group in _GROUPS_OF_FIRST_USER and ubuntu_codename(stage.origin) not in _WITHOUT_USER:
        return True
    steps = "\n".join(str(each.value) for one in stage.chain for each in one.all("RUN", "COPY"))
    return bool(re.search(rf"\b{re.escape(group)}\b|\$\{{?GROUP|\.sh\b", steps))
