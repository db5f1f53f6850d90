"""What services run as root although it needs no root."""

from __future__ import annotations

from enum import Enum

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_HOME = regex(r"/home/([^/]+)/", 0, "/home/")
_INTERPRETER = regex(r"(?:python[0-9.]*|node|nodejs|ruby|perl|bash|sh|dash)$", 0, "python node ruby perl sh")
_OF_DISTRIBUTION = ("/usr/lib/", "/usr/share/", "/usr/bin/", "/lib/")
_RELAYS = frozenset(
    "socat nc ncat netcat websockify ttyd gunicorn uvicorn mjpg_streamer x0vncserver x0tigervncserver x11vnc jupyter "
    "jupyter-lab jupyter-notebook code-server foxglove_bridge node-red".split()
)
_OWN_PLACE = regex(r"/(?:opt|srv)/", 0, "/opt/ /srv/")
_NEEDS_ROOT = regex(
    r"\b(?:ip (?:-\S+ ){0,8}link|ifconfig|modprobe|insmod|mount|iptables|nft|sysctl|systemctl|nvpmodel|jetson_clocks"
    r"|slcand|hci(?:config|attach)|btattach|rfkill|reboot|poweroff|shutdown|chown|setcap|ufw|apt-get|dpkg|raspi-config"
    r"|user(?:add|mod)|hostnamectl|update-grub)\b|\bapt (?:-\S+ ){0,4}(?:install|update|upgrade)\b"
    r"|/boot/(?:firmware/)?\w+\.txt"
)
"""What a script does that only root may."""
_CONTAINERS = frozenset(
    {
        "docker",
        "nvidia-docker",
        "docker-compose",
        "podman",
        "podman-compose",
        "nerdctl",
        "systemd-nspawn",
        "machinectl",
        "lxc",
    }
)
_DROPPERS = frozenset({"setpriv", "runuser", "su", "sudo", "gosu", "su-exec", "chpst", "s6-setuidgid"})


class Work(Enum):
    ROS = "ROS"
    PROBABLY_ROS = "a script outside the tree, in a tree for ROS"
    IN_HOME = "a program in the home of a user, who can change it"
    SET_UP_IN_HOME = "the same, where what it does once, or anything that it does, may need root"
    OWN_SCRIPT = "a script that the distribution does not ship"
    OWN_PROGRAM = "a program that no package of the distribution brings"
    RELAY = "a program that relays data"


class NeedlessRoot(NamedTuple):
    """What a command line runs that needs no root."""

    work: Work
    where: Located
    owner: str = ""
    """For ``IN_HOME`` and ``SET_UP_IN_HOME``: the user."""


def reads_display_of_root(unit: Unit, units: Units) -> bool:
    """Whether the authority file of the display, which the program has to read, belongs to root."""
    authority = units.environment(unit).text("XAUTHORITY")
    return authority is not None and "root" in authority.split("/")


def changes_user(process: Process) -> bool:
    """Whether the command line gives root up itself, or starts a container. What a program in a home gives up later
    comes too late."""
    home = any(_HOME.match(word) for word in process.argv[:1])
    if home and process.unit.get("Type") in ("oneshot", "forking"):
        return False
    for step in process.steps:
        words = step.command.words[:2] if step.command.name == "exec" else step.command.words[:1]
        if any(program_name(word) in _DROPPERS or program_name(word) in _CONTAINERS for word in words):
            return True
    return False


def _programs(process: Process) -> tuple[Located, ...]:
    """The program, and the script that it interprets; arguments of other programs are only files."""
    words = unwrapped(process.argv)
    return words[:2] if words and _INTERPRETER.match(program_name(words[0])) else words[:1]


def needless_root(process: Process, units: Units) -> NeedlessRoot | None:
    """What a command line runs that needs no root; None when it may need it."""
    if process.mentions_ros or process.is_ros1:
        return NeedlessRoot(Work.ROS, process.ros[0][1].where if process.ros else process.program)
    script = process.script_outside_tree
    if script is not None and process.unit in units.presumed_ros:
        return NeedlessRoot(Work.PROBABLY_ROS, script)
    paths = [word for word in _programs(process) if word.startswith("/")]
    ends = process.unit.get("Type") in ("oneshot", "forking")
    for path in paths:
        home = _HOME.match(path)
        if home:
            sets_up = ends or _needs_root(process, units)
            return NeedlessRoot(Work.SET_UP_IN_HOME if sets_up else Work.IN_HOME, path, home[1])
    if ends or _needs_root(process, units):
        return None
    if _INTERPRETER.match(process.name) and len(paths) > 1 and not paths[1].startswith(_OF_DISTRIBUTION):
        return NeedlessRoot(Work.OWN_SCRIPT, paths[1])
    if process.name in _RELAYS:
        return NeedlessRoot(Work.RELAY, process.program)
    return NeedlessRoot(Work.OWN_PROGRAM, process.program) if _OWN_PLACE.match(process.program) else None


def _needs_root(process: Process, units: Units) -> bool:
    """Whether the unit does something that only root may, in any of its command lines."""
    return any(_NEEDS_ROOT.search(text) for each in units.processes(process.unit) for text in each.texts)
