"""Launch files of ROS 2, and the build files that say what a package installs."""

from __future__ import annotations

import re

from bringup_lint.discover.kinds import Head
from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

LAUNCH = ("launch-python", "launch-xml", "launch-yaml")
"""The launch files of ROS 2."""

_PYTHON = regex(r"(?:[._-]launch\.py|/launch/(?:[^/]+/)*[^/]+\.py)$")
_XML = regex(r"[._-]launch\.xml$|/launch/[^/]+\.xml$")
_YAML = regex(r"[._-]launch\.ya?ml$|/launch/[^/]+\.ya?ml$")
_ENTRY = regex(r"^[^\S\n]*(?:async\s+)?def generate_(?:launch|test)_description\b", re.M)
_LAUNCH_IMPORT = regex(r"^[^\S\n]*(?:from|import)\s+launch(?:_ros)?\b", re.M)
_ROOT = regex(r"^\s*(?:<\?xml(?:(?!\?>).)*\?>\s*)?(?:<!--(?:(?!-->).)*-->\s*|<!DOCTYPE[^>]*>\s*)*<launch\b", re.S)
_ROS1 = regex(
    r"\$\((?:arg|find|optenv)\s|<rosparam\b|<machine\b|<node\b[^<>]*\stype\s*=|<include\b[^<>]*\sns\s*=|<test\b"
)
_ROS2 = regex(
    r"\$\((?:var|find-pkg-share|find-pkg-prefix|dirname|exec-in-pkg)\b|<node\b[^<>]*\sexec\s*=|<let\b|<executable\b"
    r"|<push[-_]ros[-_]namespace\b|<node_container\b|<set_parameter\b|<load_composable_node\b"
)
_YAML_ROOT = regex(r"^launch\s*:", re.M)
_PACKAGE = regex(r"<package\b|\bpackage_format\d\.xsd\b")
_SETUP = regex(r"\bsetup\s*\(")


def _is_python(path: str, head: Head) -> bool:
    path = f"/{path}"
    if not _PYTHON.search(path) or path.endswith(("/__init__.py", "/conftest.py")):
        return False
    text = head()
    if path.endswith(".launch.py"):
        return True
    return bool(_ENTRY.search(text) or _LAUNCH_IMPORT.search(text))


def _is_xml(path: str, head: Head) -> bool:
    path = f"/{path}"
    if path.endswith(".launch"):
        text = head()
        if not _ROOT.match(text):
            return False
        text = _uncommented(text)
        return bool(_ROS2.search(text)) and not _ROS1.search(text)
    return bool(_XML.search(path)) and bool(_ROOT.match(head()) or path.endswith(".launch.xml"))


def _uncommented(text: str) -> str:
    """The text without comments, which keep what the file was in ROS 1."""
    first, *others = text.split("<!--")
    return first + "".join(each.partition("-->")[2] for each in others)


def _is_ros1(path: str, head: Head) -> bool:
    return path.endswith(".launch") and bool(_ROOT.match(head())) and not _is_xml(path, head)


def _is_yaml(path: str, head: Head) -> bool:
    return bool(_YAML.search(f"/{path}")) and bool(_YAML_ROOT.search(head()))


KINDS = (
    Kind("launch-python", _is_python),
    Kind("launch-xml", _is_xml),
    Kind("launch-ros1", _is_ros1),
    Kind("launch-yaml", _is_yaml),
    Kind("ros-package", lambda path, head: f"/{path}".endswith("/package.xml") and bool(_PACKAGE.search(head()))),
    Kind("setup-py", lambda path, head: f"/{path}".endswith("/setup.py") and bool(_SETUP.search(head()))),
    Kind("setup-cfg", lambda path, head: f"/{path}".endswith("/setup.cfg")),
    Kind("cmake", lambda path, head: f"/{path}".endswith("/CMakeLists.txt")),
)
