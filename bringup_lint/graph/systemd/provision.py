"""Files of a robot that a script of the repository makes, so that nothing in the tree holds them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.folders import above
from bringup_lint.graph.memo import kept
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree

_SCRIPT = regex(
    r"(?:\.(?:sh|bash|py|ya?ml|cmake|mk|bb|bbappend|install|postinst|preinst|j2|toml|nix)"
    r"|(?:^|/)(?:Makefile|Dockerfile\S*|Containerfile|CMakeLists\.txt|justfile|rules|postinst))$"
)
_LOOKS = (
    r"[ \t]*(?:#|(?:(?:exec|sudo|nice)[ \t]+)*(?:find|rm|rmdir|du|df|ls|cat|tail|head|less|stat|test|\[)[ \t]"
    r"|WorkingDirectory=|(?:rsync|scp)[ \t]|ssh[ \t][^\n]{0,200}[ \t'\"](?:rm|ls|du|find|tail|cat)[ \t])"
)
"""How lines begin that take for granted that a path is there."""
_GUIDE = regex(r"(?:\.(?:md|rst|dirs|install|tmpfiles?)|(?:^|/)(?:dirs|README))$")
_BUILD = regex(
    r"(?:\.(?:cmake|mk|bb|bbappend|install|nix|spec|toml)|(?:^|/)(?:Makefile|CMakeLists\.txt|setup\.(?:py|cfg)|justfile|rules"
    r"|Dockerfile[^/]*|Containerfile))$"
)
_OPEN = regex(r"[*$]|\{\{|[ \t]-\w{0,5}[rRa]|\b(?:rsync|tar|unzip|git|scp)\b|\bdest[\"']?:")
"""Lines whose files are not all named."""
_SYSTEMCTL = regex(r"\bsystemctl\b([^\n|;&]*)", hints="systemctl")
_STARTS = regex(r"\s(?:re)?start\s")
_UNIT = regex(r"[\w.@:\\-]+")
_TASK = regex(
    r"\bname:\s*[\"']?([^\s\"']+)[\"']?[ \t]*\n(?=(?:[ \t]+\w+:.*\n){0,6}?[ \t]+state:\s*[\"']?(?:re)?started\b)",
    hints="started",
)
_SIZE = 512 * 1024
_COUNT = 3000
"""Bytes of a script and scripts of a tree that are looked at, at most."""


def makes(tree: Tree, name: str) -> bool:
    """Whether a script or recipe of the tree names a file of that name by a path, or redirects into it."""
    written = re.compile(rf"(?:[/>]\s*|\b(?:tee|cat|touch)\s+(?:-\S+\s+)*[\"']?){re.escape(name)}(?![\w.-])")
    return any(name in text and written.search(text) for text in scripts_of(tree))


def makes_at(tree: Tree, folder: str, name: str) -> bool:
    """Whether the tree may put a file of that name into a folder of the robot without the whole path: a build that
    names it, or a line that fills the folder, or one above, with what it does not name."""
    if any(name in tree.head(path, _SIZE) for path in tree.like(_BUILD)):
        return True
    places = "|".join(re.escape(each) for each in (folder, *above(folder)) if each.count("/") > 1 or each == folder)
    line = rf"^(?![ \t]*#)[^\n]*(?<![\w.}}/-])(?:{places})/?(?![\w./-])[^\n]*"
    return any(_OPEN.search(found) for text in scripts_of(tree) for found in re.findall(line, text, re.M))


def mentions(tree: Tree, path: str) -> bool:
    """Whether a script or recipe of the tree has to do with a path, other than to look at it or to clear it."""
    there = rf"[^\n]*{re.escape(path)}(?![\w.-])"
    written = re.compile(rf"^(?:(?!{_LOOKS}){there}|[ \t]*(?:rsync|scp)[ \t]{there}\S*[ \t]*$)", re.M)
    return any(path in text and written.search(text) for text in scripts_of(tree))


def may_make(tree: Tree, path: str) -> bool:
    """Whether something of the tree may make a folder without naming it as a script would: with a variable for a part
    of it, in a list of debhelper, or by hand as a guide says."""
    parts = path.strip("/").split("/")
    heads = (re.escape("/".join(parts[:count])) for count in range(2, len(parts)))
    tails = (re.escape("/".join(parts[count:])) for count in range(1, len(parts)))
    by_variable = rf"/(?:{'|'.join(heads)})/[\"']?(?:\$|\{{\{{)|(?:\$\w+|\}})[\"']?/(?:{'|'.join(tails)})(?![\w.-])"
    by_list = rf"^{re.escape('/'.join(parts))}/?[ \t]*$"
    by_hand = rf"\b(?:mkdir|install|useradd|adduser)\b[^\n]{{0,200}}{re.escape(path)}(?![\w.-])"
    written = re.compile(f"{by_variable}|{by_list}|{by_hand}", re.M)
    guides = (tree.head(each, _SIZE) for each in tree.like(_GUIDE))
    return any(parts[-1] in text and written.search(text) for text in guides) or any(
        map(written.search, scripts_of(tree))
    )


def starts(tree: Tree, unit: str) -> bool:
    """Whether a script or an Ansible task of the tree starts the service by its name."""
    return unit.removesuffix(".service") in _started(tree)


@kept
def _started(tree: Tree) -> frozenset[str]:
    """What scripts and Ansible tasks start, without its ending."""
    found: set[str] = set()
    for text in scripts_of(tree):
        for command in _SYSTEMCTL.findall(text):
            verb = _STARTS.search(command)
            found.update(_UNIT.findall(command, verb.end()) if verb is not None else ())
        found.update(_TASK.findall(text))
    return frozenset(name.removesuffix(".service") for name in found)


def naming(tree: Tree, pattern: re.Pattern[str]) -> Iterator[str]:
    """The paths of the scripts, recipes and plays that a pattern fits."""
    yield from (path for path in tree.like(_SCRIPT)[:_COUNT] if pattern.search(tree.head(path, _SIZE)))


def scripts_of(tree: Tree) -> Iterator[str]:
    """The texts of the scripts, recipes and plays of a tree."""
    for path in tree.like(_SCRIPT)[:_COUNT]:
        yield tree.head(path, _SIZE)
