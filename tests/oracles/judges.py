"""What the real readers say of a file: complaints without their line numbers, empty when it is accepted."""

from __future__ import annotations

import ast
import configparser
import importlib.util
import os
import re
import shutil
import subprocess
import tempfile
from collections import Counter
from collections.abc import Callable
from collections.abc import Iterator
from pathlib import Path

import yaml

from bringup_lint.parsers.yaml_kinds import YAML_KINDS
from bringup_lint.suppress.forms import PYTHON_KINDS
from bringup_lint.suppress.forms import XML_KINDS
from tests.oracles import cyclonedds_library
from tests.oracles import fastdds_library
from tests.oracles import sshd_server
from tests.oracles import systemd_daemons
from tests.oracles import test_launch_grammar
from tests.oracles import test_netplan
from tests.oracles import test_params
from tests.oracles import udevadm
from tests.oracles import verify

Judge = Callable[[Path], Counter[str]]
REFUSED = "refused"
"""What a tool comes to that warns of mistakes, and stops at the first one that is more."""
_OF_THE_HOST = re.compile(r"No such file or directory|^reading config file|^considering log")
"""What depends on the files of the machine that runs the tests."""
_ENDPOINTS = frozenset(["create_publisher", "create_subscription", "create_client", "create_service"])


def said(*command: str) -> Counter[str]:
    run = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
    lines = [line for line in (run.stdout + run.stderr).splitlines() if not _OF_THE_HOST.search(line)]
    return Counter(re.sub(r"\d+", "0", line) for line in lines if re.search(r"error|bad|invalid|unknown", line, re.I))


def systemd(path: Path) -> Counter[str]:
    lines, whole = verify.verify([path]).of(path)
    return Counter(
        re.sub(r"\d+", "0", text)
        for texts in (*lines.values(), whole)
        for text in texts
        if not _OF_THE_HOST.search(text)
    )


def logrotate(path: Path) -> Counter[str]:
    path.chmod(0o644)
    return said("logrotate", "-d", "-s", "/dev/null", str(path))


def udev(path: Path) -> Counter[str]:
    return Counter(text for texts in udevadm.verify([path]).values() for text in texts)


def python(path: Path) -> Counter[str]:
    try:
        ast.parse(path.read_text("utf-8-sig"))
    except SyntaxError as error:
        return Counter([error.msg])
    return Counter()


def libyaml(path: Path) -> Counter[str]:
    try:
        list(yaml.compose_all(path.read_text("utf-8-sig"), Loader=yaml.CSafeLoader))
    except yaml.YAMLError as error:
        return Counter([type(error).__name__])
    return Counter()


def libxml2(path: Path) -> Counter[str]:
    from lxml import etree

    try:
        etree.fromstring(path.read_bytes())
    except etree.XMLSyntaxError:
        return Counter(["XMLSyntaxError"])
    return Counter()


def netplan(path: Path) -> Counter[str]:
    with tempfile.TemporaryDirectory() as folder:
        verdict = test_netplan.real(path.read_text("utf-8-sig"), Path(folder, "root"))
    return Counter() if verdict.accepted else Counter([re.sub(r"\d+", "0", verdict.message)])


def sshd(path: Path) -> Counter[str]:
    with sshd_server.sshd_folder() as folder:
        run = sshd_server.sshd(folder, path.read_text("utf-8"), "-t")
    lines = run.stderr.replace(str(folder), "").splitlines()
    return Counter(re.sub(r"\d+", "0", line) for line in lines)


def rcl(path: Path) -> Counter[str]:
    (table,) = test_params.ask([{"text": path.read_text("utf-8")}])
    return Counter(["refused"] if table is None else [])


def launch(path: Path) -> Counter[str]:
    """What ROS's own launch says of a launch file that it loads."""
    (error,) = test_launch_grammar.reference([[path.name, path.read_text("utf-8-sig")]])
    return Counter([error] if error else [])


def journald(path: Path) -> Counter[str]:
    return systemd_daemons.complaints(path, "journald.conf")


def logind(path: Path) -> Counter[str]:
    return systemd_daemons.complaints(path, "logind.conf")


def manager(path: Path) -> Counter[str]:
    return systemd_daemons.complaints(path, "system.conf")


def nmcli(path: Path) -> Counter[str]:
    """What libnm says of a profile that it would write anew."""
    run = subprocess.run(
        ["nmcli", "--offline", "connection", "modify", "connection.zone", "home"],
        input=path.read_text("utf-8-sig"),
        capture_output=True,
        text=True,
        env={**os.environ, "LC_ALL": "C"},
        check=False,
    )
    return Counter(re.sub(r"\d+", "0", line) for line in run.stderr.splitlines())


def hadolint(path: Path) -> Counter[str]:
    """Its warnings, and what its parser cannot read."""
    run = subprocess.run(
        ["hadolint", "--no-color", "-"], input=path.read_text("utf-8"), capture_output=True, text=True, check=False
    )
    lines = (run.stdout + run.stderr).splitlines()
    said = Counter(re.sub(r"\d+", "0", line) for line in lines)
    return said if all(re.search(r" (DL|SC)\d+ ", line) for line in lines) else said + Counter([REFUSED])


def apt(path: Path) -> Counter[str]:
    return Counter(
        subprocess.run(["apt-config", "-c", path, "dump"], capture_output=True, text=True).stderr.split("\n")
    )


def bash(path: Path) -> Counter[str]:
    run = subprocess.run(["bash", "-n"], input=path.read_bytes(), capture_output=True, check=False)
    return Counter(re.sub(r"\d+", "0", line) for line in run.stderr.decode("utf-8", "replace").splitlines())


def crontab(path: Path) -> Counter[str]:
    """What Debian's crontab says of a table that it would install; the user of a system's table is a word to it."""
    run = subprocess.run(["crontab", "-n", str(path)], capture_output=True, text=True, check=False)
    lines = [] if run.returncode == 0 else run.stderr.replace(str(path), "").splitlines()
    return Counter(re.sub(r"\d+", "0", line) for line in lines)


def endpoints(text: str) -> Iterator[str]:
    """The names that a node writes down for its topics and services."""
    for call in ast.walk(ast.parse(text)):
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute):
            continue
        if call.func.attr in _ENDPOINTS and len(call.args) > 1 and isinstance(call.args[1], ast.Constant):
            yield str(call.args[1].value)


def rclpy(path: Path) -> Counter[str]:
    """What the real rclpy says of the names of topics and services in a node."""
    from rclpy.validate_topic_name import validate_topic_name

    said: Counter[str] = Counter()
    for name in endpoints(path.read_text("utf-8-sig")):
        try:
            validate_topic_name(name)
        except Exception as error:
            said[type(error).__name__] += 1
    return said


def ini(path: Path) -> Counter[str]:
    """What fail2ban and setuptools read such files with."""
    parser = configparser.RawConfigParser(strict=False)
    try:
        parser.read_string(path.read_text("utf-8-sig"))
    except configparser.Error as error:
        return Counter([type(error).__name__])
    return Counter()


def findmnt(path: Path) -> Counter[str]:
    """What it says of the words; whether a device is there depends on the host."""
    run = subprocess.run(["findmnt", "--verify", "--tab-file", str(path)], capture_output=True, text=True, check=False)
    lines = (line.strip() for line in (run.stdout + run.stderr).splitlines())
    return Counter(re.sub(r"\d+", "0", line) for line in lines if re.search(r"parse error|wrong|undefined", line))


def cyclonedds(path: Path) -> Counter[str]:
    """What Cyclone DDS says when a participant starts in the first domain that the file is for."""
    number = re.search(r"<Domain\s[^>]*\bId\s*=\s*[\"'](\d{1,3})[\"']", path.read_text("utf-8-sig"), re.I)
    domain = int(number[1]) if number else 0
    with tempfile.TemporaryDirectory() as folder:
        (verdict,) = cyclonedds_library.ask([f"file://{path}"], Path(folder), domain)
    lines = re.sub(r" \([^()]*line \d+\)", "", verdict.message).split("; ")
    said = Counter(re.sub(r"\d+", "0", line) for line in lines if line not in ("accepted", "refused"))
    return said if verdict.accepted else said + Counter([REFUSED])


def fastdds(path: Path) -> Counter[str]:
    """What Fast DDS says when it loads the file."""
    with tempfile.TemporaryDirectory() as folder:
        (verdict,) = fastdds_library.ask([path.read_text("utf-8-sig")], Path(folder))
    return Counter(verdict.message.split("; ") if verdict.result != fastdds_library.LOADED else [])


READERS: dict[str, tuple[str, Judge]] = {
    "cyclonedds": ("Cyclone DDS", cyclonedds),
    "fastdds": ("Fast DDS", fastdds),
    "systemd-unit": ("systemd-analyze verify", systemd),
    "systemd-dropin": ("systemd-analyze verify", systemd),
    "logrotate": ("logrotate -d", logrotate),
    "udev-rules": ("udevadm verify", udev),
    "netplan": ("netplan generate", netplan),
    "sshd-config": ("sshd -t", sshd),
    "params": ("rcl", rcl),
    "launch-python": ("launch", launch),
    "launch-xml": ("launch", launch),
    "launch-yaml": ("launch", launch),
    "fstab": ("findmnt --verify", findmnt),
    "journald-conf": ("systemd-journald", journald),
    "logind-conf": ("systemd-logind", logind),
    "system-conf": ("systemd --test", manager),
    "env-file": ("systemd's environment.d", systemd_daemons.of_environment),
    "networkmanager": ("nmcli", nmcli),
    "dockerfile": ("hadolint", hadolint),
    "apt-conf": ("apt-config", apt),
    "shell-script": ("bash -n", bash),
    "cron": ("crontab -n", crontab),
    "python-node": ("rclpy", rclpy),
    "fail2ban-jail": ("Python's configparser", ini),
    "setup-cfg": ("Python's configparser", ini),
}
"""Kind -> the program that reads it on a robot, and how to ask it."""


DAEMONS = frozenset(["systemd-journald", "systemd-logind", "systemd --test"])
PROGRAMS = frozenset(["logrotate", "findmnt", "nmcli", "hadolint", "apt-config", "bash", "crontab"])
"""Judges that are found on the path, or not at all."""
STOPS = frozenset(["launch", "netplan generate", "nmcli", "bash -n", "crontab -n", "Fast DDS"])
"""Tools that say nothing after the first mistake: without it, they come to the next one."""


def has_stopped(tool: str, said: Counter[str]) -> bool:
    """Whether a tool may have left out what it would say of the rest of a file."""
    return REFUSED in said or (tool in STOPS and bool(said))


def judges_of(kind: str) -> Iterator[tuple[str, Judge]]:
    """The tools that read files of a kind, and how to ask them."""
    if kind in READERS:
        yield READERS[kind]
    if kind in PYTHON_KINDS:
        yield "Python's ast", python
    if kind in YAML_KINDS:
        yield "libyaml", libyaml
    if kind in XML_KINDS:
        yield "libxml2", libxml2


def is_installed(tool: str) -> bool:
    if tool == "udevadm verify":
        return udevadm.udevadm() is not None
    if tool == "systemd-analyze verify":
        return verify.systemd_version() >= 250
    if tool == "netplan generate":
        return test_netplan.generator() is not None
    if tool == "sshd -t":
        return sshd_server.SSHD is not None and shutil.which("ssh-keygen") is not None
    if tool == "launch":
        return test_launch_grammar.tool() != "launch"
    if tool == "Cyclone DDS":
        return cyclonedds_library.is_installed()
    if tool == "Fast DDS":
        return fastdds_library.library() is not None
    if tool in ("rcl", "rclpy"):
        return importlib.util.find_spec("rclpy") is not None
    if tool in DAEMONS:
        return systemd_daemons.can_start_daemons()
    if tool == "systemd's environment.d":
        return systemd_daemons.GENERATOR.is_file()
    program = tool.partition(" ")[0]
    return program not in PROGRAMS or shutil.which(program) is not None
