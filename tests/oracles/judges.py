"""What the real readers say of a file: complaints without their line numbers, empty when it is accepted."""

from __future__ import annotations

import ast
import re
import shutil
import subprocess
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import yaml

from bringup_lint.suppress.forms import PYTHON_KINDS
from bringup_lint.suppress.forms import XML_KINDS
from bringup_lint.suppress.forms import YAML_KINDS
from tests.oracles import udevadm
from tests.oracles import verify

Judge = Callable[[Path], Counter[str]]
_OF_THE_HOST = re.compile(r"No such file or directory|^reading config file|^considering log")
"""What depends on the files of the machine that runs the tests."""


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


def judge_of(kind: str) -> tuple[str, Judge] | None:
    """The tool that reads files of a kind, and how to ask it; None where there is none for the tests."""
    if kind in ("systemd-unit", "systemd-dropin"):
        return "systemd-analyze verify", systemd
    if kind == "logrotate":
        return "logrotate -d", logrotate
    if kind == "udev-rules":
        return "udevadm verify", udev
    if kind in PYTHON_KINDS:
        return "Python's ast", python
    if kind in YAML_KINDS:
        return "libyaml", libyaml
    return ("libxml2", libxml2) if kind in XML_KINDS else None


def is_installed(tool: str) -> bool:
    if tool == "udevadm verify":
        return udevadm.udevadm() is not None
    if tool == "systemd-analyze verify":
        return verify.systemd_version() >= 250
    return not tool.startswith("logrotate") or shutil.which("logrotate") is not None
