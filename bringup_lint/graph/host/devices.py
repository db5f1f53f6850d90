"""Device paths that files of the robot use, joined to the udev rules that make them."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.host.device_uses import OF_VARIABLES
from bringup_lint.graph.host.device_uses import DeviceUse
from bringup_lint.graph.host.device_uses import device_path
from bringup_lint.graph.host.device_uses import of_compose
from bringup_lint.graph.host.device_uses import of_descriptions
from bringup_lint.graph.host.device_uses import of_env_files
from bringup_lint.graph.host.device_uses import of_launch
from bringup_lint.graph.host.device_uses import of_params
from bringup_lint.graph.host.device_uses import of_units
from bringup_lint.graph.host.device_uses import of_variables
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.udev.matched_devices import subsystem_of_name
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import escape_path
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import nearest
from bringup_lint.spelling import numbered
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.udev.rule import Link
    from bringup_lint.graph.udev.udev import Udev
    from bringup_lint.model.node_source import NodeSource

_BY_DISCOVERY = regex(r"/dev/(?:ttyUSB\d+|ttyACM\d+|video\d|input/event\d+|bus/usb/\d{3}/\d{3})")
_PATH = regex(r"/dev/[\w./+-]+", hints="/dev/")
_LOOP = regex(r"^\s*for\s+\w+\s+in\s")
_CAMERA = "/dev/video"
_SEPARATORS = regex(r"[/_.-]")
_PERHAPS = ("default", "argument", "script")
_LEAST = 6
"""Characters of a name that is long enough to be a misspelt one."""
_LEAST_WORD = 4
"""Of what says which device a name is for, as in ``ttyUSB_lidar``."""
_SERIAL = regex(r"^tty(?:USB|ACM|S|AMA|THS)?(?=[-_A-Z])")
_UNTRACKED = frozenset({"video4linux", "hidraw", "input", "i2c-dev", "spidev", "gpio"})
"""Subsystems of which 99-systemd.rules tags no device."""
_NUMBERED = regex(r"/dev/(?:input/)?[a-z0-9]+?-?\d+(?:\.\d+)?")
_TAGGED = regex(r"TAG[ \t]*\+?=[ \t]*\"systemd", hints="TAG")
_OF_THE_ROBOT = ("systemd-unit", "compose", "params", "udev-rules", *OF_VARIABLES)
_OF_DRIVERS = ("compose", "params")
_OF_KERNEL = frozenset(
    [
        "block",
        "bus",
        "char",
        "cpu",
        "disk",
        "dma_heap",
        "dri",
        "fd",
        "hugepages",
        "infiniband",
        "input",
        "iio",
        "mapper",
        "mqueue",
        "mtd",
        "net",
        "pts",
        "serial",
        "shm",
        "snd",
        "usb",
        "v4l",
        "vfio",
        "vg",
        "xen",
    ]
)
"""Folders of /dev that the kernel, systemd or the packaged udev rules fill."""
_SHARED = frozenset({"input", "serial", "usb"})
"""Those among them where robots put links of their own beside the kernel's names."""


_NODES = regex(
    r"(?:apex|autofs|btrfs|console|cpu_dma|cuse|dma|drm|dxg|fuse|galcore|gpio|hailo|hpet|i2c|iio|ion|kfd|kmsg|kvm"
    r"|loop|mali|mei|mpp|msr|mwave|nv|ppp|ptmx|rfkill|rga|rknpu|rtc|spi|tegra|tpm|tty(?!(?:USB|ACM)[^\d])|tun|uhid|uinput|uio|vc|vcio|vhost"
    r"|vhci|vsock|watchdog|xdma|zram).*|full|hwrng|mem|ng\d.*|null|port|ram\d*|u?random|sg\d+|std(?:in|out|err)|zero"
)
"""Begins the names that drivers and the kernel give to their nodes."""


class Meant(NamedTuple):
    link: Link
    unit: str
    """The name of its device unit."""


@dataclass(frozen=True, eq=False)
class Devices:
    """All uses of device paths in units with their scripts and environments, compose and launch files."""

    files: Files
    udev: Callable[[], Udev]
    units: Callable[[], Units]
    compose: Callable[[], Compose]
    launch: Callable[[], Launch]
    params: Callable[[], Params]
    python: Callable[[], Iterable[NodeSource]]
    """The nodes in Python, with the modules that they import."""

    @cached_property
    def uses(self) -> tuple[DeviceUse, ...]:
        found: dict[tuple[Source, int], DeviceUse] = {}
        for use in self._all_uses():
            simulated = self.files.purpose(use.path) is Purpose.SIMULATION
            if not simulated and (use.certainty == "host" or use.path not in self._inside_containers):
                found.setdefault((use.path.span.source, use.path.span.start), use)
        return tuple(found.values())

    def _all_uses(self) -> Iterator[DeviceUse]:
        """Only layers whose kinds of file the tree holds are asked."""
        if self.files.of_kind("systemd-unit", "systemd-dropin"):
            yield from of_units(self.units())
        if self.files.of_kind("compose"):
            yield from of_compose(self.compose())
            yield from of_env_files(self.compose(), self.files)
        if self.files.of_kind("launch-python", "launch-xml", "launch-ros1", "launch-yaml"):
            yield from of_launch(self.launch())
        if self.files.of_kind("params"):
            yield from of_params(self.params())
        if self.files.of_kind("urdf"):
            yield from of_descriptions(self.files)
        if self.files.of_kind(*OF_VARIABLES):
            yield from of_variables(self.files)
        if self.files.of_kind("python-node", "cpp-node"):
            from bringup_lint.graph.host.device_code import of_sources

            yield from of_sources(self.files, self.python)

    @cached_property
    def _inside_containers(self) -> frozenset[str]:
        """Paths that compose gives to devices inside a container, other than their own."""
        return frozenset(inside for _, inside in self.renamed)

    @cached_property
    def renamed(self) -> frozenset[tuple[str, str]]:
        """The paths of devices, each with another one that compose gives to it in a container."""
        if not self.files.of_kind("compose"):
            return frozenset()
        from bringup_lint.model.compose import split

        mappings = [split(device.where) for service in self.compose().services for device in service.devices]
        return frozenset((str(each[0]), str(each[1])) for each in mappings if len(each) > 1 and each[0] != each[1])

    @property
    def unstable(self) -> Iterator[tuple[DeviceUse, list[Link]]]:
        """Uses of a name that changes with the order of discovery, with the links that may be meant."""
        for use in self.uses:
            if _BY_DISCOVERY.fullmatch(use.path):
                yield use, [link for link in self.udev().stable_names(use.path) if self._is_near(link, use)]

    def beside(self, use: DeviceUse) -> Located | None:
        """A serial device of the same kind beside one that a path means: of another number, or where a script looks
        through all of them."""
        family = _family(use.path)
        if not family:
            return None
        others = (where for path, where in self._numbered.get(family, {}).items() if path != use.path)
        return next(others, None) or next(self._looked_through(family), None)

    @cached_property
    def _numbered(self) -> dict[str, dict[str, Located]]:
        """The numbered names of each kind that the robot's own files use, and where first."""
        found: dict[str, dict[str, Located]] = {}
        for use in self.uses:
            family = _family(use.path)
            if family and use.path not in found.get(family, ()) and not self.is_default(use):
                if self.files.purpose(use.path) is Purpose.ROBOT:
                    found.setdefault(family, {})[str(use.path)] = use.path
        return found

    def _looked_through(self, family: str) -> Iterator[Located]:
        loop = f"{family}*"
        for source in self.files.of_kind("shell-script"):
            at = source.text.find(loop)
            if at >= 0 and _LOOP.search(source.line_text(source.located(at, at).span.line)):
                if source.judged and self.files.purpose(source) is Purpose.ROBOT:
                    yield source.located(at, at + len(loop))

    def is_default(self, use: DeviceUse) -> bool:
        """Whether a path is only what the launch file of a driver starts with, for whoever uses it to replace."""
        from bringup_lint.graph.host.driver_defaults import is_driver_launch

        source = use.path.span.source
        return source.kind.startswith("launch-") and is_driver_launch(source, self.launch())

    def is_single_camera(self, use: DeviceUse) -> bool:
        """Whether something opens the only camera that the tree names by its number.

        A unit or a variable of Ansible says what this robot has: there, the number counts. So it does in a parameter
        file and for a container, unless it is the first.
        """
        if not use.path.startswith(_CAMERA):
            return False
        kind = use.path.span.source.kind
        if kind in _OF_THE_ROBOT and not (kind in _OF_DRIVERS and use.path == f"{_CAMERA}0"):
            return False
        return self._numbered_cameras == 1

    @cached_property
    def _numbered_cameras(self) -> int:
        """How many cameras the tree names by their numbers."""
        paths = {str(use.path) for use in self.uses if _BY_DISCOVERY.fullmatch(use.path)}
        return sum(path.startswith(_CAMERA) for path in paths)

    @property
    def undefined(self) -> Iterator[tuple[DeviceUse, Link | None]]:
        """Uses of a link that no rule makes in a folder where rules make links, with the nearest one; of those in /dev
        itself only where a rule makes nearly the same name."""
        if not self.uses or not self.files.of_kind("udev-rules"):
            return
        yield from self._nearly_made
        for use in self.uses:
            if use.path.count("/") < 3 or _always_there(use.path):
                continue
            own = [link for link in self.udev().links if link.is_fixed and self._is_near(link, use)]
            folders = {link.path.rpartition("/")[0] for link in own} - {"/dev"}
            names = {link.path: link for link in own}
            escaped = use.certainty == "unit" and self.meant_by(use.path.span.text) is not None
            if use.path.rpartition("/")[0] in folders and not escaped and not self.udev().links_to(use.path):
                near = nearest(use.path, names)
                yield use, names[near[0]] if len(near) == 1 else None

    @property
    def _nearly_made(self) -> Iterator[tuple[DeviceUse, Link]]:
        """Uses of a name in /dev that only differs from that of a link in its separators or in a letter or two."""
        for use in self.uses:
            name = use.path.removeprefix("/dev/")
            if "/" in name or use.certainty in _PERHAPS or len(name) < _LEAST or subsystem_of_name(name) is not None:
                continue
            if self.udev().links_to(use.path):
                continue
            own = [link for link in self.udev().links if link.is_fixed and self._is_near(link, use)]
            like = [link for link in own if _is_nearly(name, link.path.removeprefix("/dev/"))]
            if len({link.path for link in like}) == 1:
                yield use, like[0]

    @property
    def not_handed(self) -> Iterator[tuple[DeviceUse, Link]]:
        """Links that a service hands to its container and that no rule makes, where a rule makes another that it
        hands to it, which is given too."""
        if not self.uses or not self.files.of_kind("udev-rules"):
            return
        undefined = {use for use, _ in self.undefined}
        handed: dict[tuple[Source, str], list[DeviceUse]] = {}
        for use in self.uses:
            if use.certainty == "host" and use.path.count("/") == 2 and use not in undefined:
                handed.setdefault((use.path.span.source, use.user), []).append(use)
        for uses in handed.values():
            links = (link for use in uses for link in self.udev().links_to(use.path) if self._is_near(link, use))
            made = next((link for link in links if link.is_fixed), None)
            if made is not None:
                yield from ((use, made) for use in uses if self._is_made_by_nobody(use))

    @property
    def unmade(self) -> Iterator[tuple[list[DeviceUse], Link]]:
        """Links in /dev itself that a file of the robot names and no rule makes, where its rules make another one there
        that such a file names, or that nothing names and whose name begins with the same word; it is given too."""
        if not self.uses or not self.files.of_kind("udev-rules"):
            return
        known = {use.path.span for use, _ in (*self.undefined, *self.not_handed)}
        own = [use for use in self.uses if use.path.count("/") == 2 and use.certainty not in (*_PERHAPS, "host")]
        own = [use for use in own if use.path.span.source.kind in _OF_THE_ROBOT]
        links = [link for use in own for link in self.udev().links_to(use.path) if link.is_fixed]
        found: dict[Source, list[DeviceUse]] = {}
        for use in own:
            if use.path.span not in known and self._is_made_by_nobody(use):
                found.setdefault(use.path.span.source, []).append(use)
        for uses in found.values():
            made = next((link for link in links if self._is_near(link, uses[0])), None) or self._unused_like(uses)
            if made is not None:
                yield uses, made

    def _unused_like(self, uses: Iterable[DeviceUse]) -> Link | None:
        """A link in /dev itself that nothing names, and whose name has the first of several words with one that is
        used."""
        words = {_first_word(use.path) for use in uses} - {""}
        opened = {str(use.path) for use in self.uses}
        for link in self.udev().links:
            is_like = link.is_fixed and link.path.count("/") == 2 and _first_word(link.path) in words
            if is_like and link.path not in opened and not self.names(link.path):
                if any(self._is_near(link, use) for use in uses):
                    return link
        return None

    def _is_made_by_nobody(self, use: DeviceUse) -> bool:
        """Whether a name in /dev is a link, by its form, and no rule may make it."""
        return is_link_by_form(use.path) and not self.udev().links_to(use.path)

    def _is_near(self, link: Link, use: DeviceUse) -> bool:
        """Whether the rule that makes a link is for the robot on which it is used."""
        return self.files.same_robot(link.name, use.path)

    def names(self, path: str) -> bool:
        """Whether anything but a udev rule names a path below /dev, or one of those that ``*`` stands for."""
        stem, star, _ = path.partition("*")
        return path in self._named or (bool(star) and any(each.startswith(stem) for each in self._named))

    @cached_property
    def _named(self) -> frozenset[str]:
        texts = (source.text for source in self.files.sources if source.kind != "udev-rules" and source.judged)
        return frozenset(path.rstrip("./") for text in texts for path in _PATH.findall(text))

    def untagged(self, unit: str) -> list[Link]:
        """The links behind a ``.device`` name when none of their devices becomes a device unit."""
        if not self.files.of_kind("udev-rules"):
            return []
        links = [link for link in self.udev().links_to(device_path(unit) or "") if link.is_fixed]
        return links if links and not any(self._is_device_unit(link) for link in links) else []

    def untracked(self, unit: str) -> str | None:
        """The path behind a ``.device`` name when it is one of the kernel that systemd does not hear of, and no rule of
        the tree tells it of any device."""
        path = device_path(unit) or ""
        name = path.rpartition("/")[2]
        if subsystem_of_name(name) not in _UNTRACKED or not _NUMBERED.fullmatch(path) or self.files.mentions(_TAGGED):
            return None
        return path

    def _is_device_unit(self, link: Link) -> bool:
        """Whether systemd hears of the device, for sure or perhaps."""
        rule = link.rule
        tagged = rule.is_tagged_by_systemd(self.files.target.systemd) is not False
        return tagged or self.udev().set_of(rule).sets_beside(rule, "TAG", "systemd")

    def meant_by(self, unit: str) -> Meant | None:
        """The link that a ``.device`` name was to stand for, when its dashes make it mean another path."""
        path = device_path(unit) if self.files.of_kind("udev-rules") else None
        if path is None or "/" not in path or self.udev().links_to(path):
            return None
        for link in self.udev().links:
            if link.is_fixed and "-" in link.path and link.path.replace("-", "/") == path:
                return Meant(link, escape_path(link.path) + ".device")
        return None

    @property
    def without_rules(self) -> Iterator[DeviceUse]:
        """Uses of a link in a folder of one's own, in a tree without any udev rule."""
        if self.files.of_kind("udev-rules") and self.udev().rules:
            return
        for use in self.uses:
            parts = use.path.split("/")
            if len(parts) > 3 and parts[2] not in _OF_KERNEL:
                yield use


def _first_word(path: str) -> str:
    """The first of several words of a name in /dev; empty for a name of one word."""
    first, *others = _SEPARATORS.split(path.removeprefix("/dev/"))
    return first if others else ""


def _is_nearly(name: str, other: str) -> bool:
    """Whether one name below /dev may be the other, misspelt. Those that differ in a number are two names."""
    if numbered(name, other):
        return False
    words = [_SEPARATORS.sub("", _SERIAL.sub("", each)).lower() for each in (name, other)]
    same_word = words[0] == words[1] and len(words[0]) >= _LEAST_WORD
    return same_word or _SEPARATORS.sub("", name) == _SEPARATORS.sub("", other) or bool(nearest(name, [other]))


def is_link_by_form(path: str) -> bool:
    """Whether a path in /dev itself has none of the names that the kernel gives to nodes."""
    name = path.removeprefix("/dev/")
    is_node = name in _OF_KERNEL or _NODES.fullmatch(name) is not None or subsystem_of_name(name) is not None
    return "/" not in name and not is_node


def _family(path: str) -> str:
    """The name of a device without its number; nothing for one that has none, and for a camera."""
    family = path.rstrip("0123456789")
    return "" if family == path or family.startswith(_CAMERA) else family


def _always_there(path: str) -> bool:
    """Whether a path in a folder of /dev is a name that the kernel or the packaged rules give."""
    _, _, folder, *rest = path.split("/")
    if folder not in _OF_KERNEL:
        return False
    return folder not in _SHARED or len(rest) > 1 or subsystem_of_name(rest[0]) is not None
