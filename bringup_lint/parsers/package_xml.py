"""package.xml, the manifest of a ROS package (REP 149)."""

from __future__ import annotations

from bringup_lint.model.package import Manifest
from bringup_lint.model.xml import Element
from bringup_lint.parsers import package_grammar
from bringup_lint.parsers import xml
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.spelling import nearest

DEPENDENCIES = frozenset(
    "depend exec_depend build_depend build_export_depend buildtool_depend test_depend run_depend group_depend".split()
)

_ROS_1 = regex(r"\$ROS_VERSION\s*==\s*[\"']?1\b|^\s*[\"']?1[\"']?\s*==\s*\$ROS_VERSION")
"""A condition of REP 149 that holds in ROS 1."""


def parse(source: Source) -> Manifest:
    """The manifest; a file that is not a package's has no name."""
    document = xml.parse(source)
    manifest = Manifest(source, problems=list(document.problems), refused=list(package_grammar.refused(document)))
    root = document.root
    if root is None or root.local != "package":
        manifest.problems.append(Problem("no-package-root", source.whole))
        return manifest
    manifest.format = {"2": 2, "3": 3}.get(str(root.get("format")), 1)
    tools = set()
    for element in root.children:
        tag = str(element.local)
        manifest.for_both |= bool(_ROS_1.search(element.get("condition") or ""))
        if tag == "name":
            manifest.name = element.text
        elif tag in DEPENDENCIES:
            manifest.depends.append((tag, element.text))
            manifest.places[tag] = element.span
            if manifest.first is None and tag != "buildtool_depend":
                manifest.first = element.span
            if tag == "buildtool_depend":
                tools.add(str(element.text))
        elif tag in ("maintainer", "author"):
            manifest.people += (element.text, element.get("email") or "")
        elif tag == "url":
            manifest.repositories.append(element.text)
        elif tag == "export":
            manifest.export = element.tag
            manifest.near_build_type = near_build_type(element.children)
            manifest.exported_depends += (each.text for each in element.children if str(each.local) in DEPENDENCIES)
            for exported in element.find_all("build_type"):
                manifest.for_both |= bool(_ROS_1.search(exported.get("condition") or ""))
                manifest.build_type = str(exported.text)
                manifest.exported_type = exported.text
    if not manifest.build_type:
        manifest.build_type = "catkin" if "catkin" in tools else ("ament_cmake" if tools else "")
    return manifest


def near_build_type(exported: list[Element]) -> Located | None:
    """A tag that is nearly ``build_type``; any other is for somebody else."""
    if any(each.local == "build_type" for each in exported):
        return None
    return next((each.name for each in exported if nearest(each.name, ["build_type"])), None)
