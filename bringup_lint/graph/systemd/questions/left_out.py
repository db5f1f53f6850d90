"""Units in the files of a role of Ansible that no task copies."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.graph.systemd.provision import scripts_of
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units

_FILE = regex(r"(?P<role>(?:^|.*/)roles/(?P<name>[^/]+))/files/(?P<path>.+)")
_EVERY = regex(
    r"\*\.(?:service|timer|socket|path)\b|\bwith_file(?:glob|tree)\b|\bfileglob\b|\bbuiltin\.find\b"
    r"|\brole_path\b|^[ \t-]*\bfind:",
    re.M,
)
"""Names for all files of a folder."""
_HIDDEN = regex(
    r"^[ \t]*(?:-[ \t]*)?(?:src|cmd):(?![ \t]*[\"']?\{\{[ \t]*item(?:\.\w+)?[ \t]*\}\}[\"']?[ \t\r]*$)"
    r"(?:[^\n]*\{\{|[^\n]*/[\"']?[ \t\r]*$|[ \t]*[\"']?\.[\"']?[ \t\r]*$)"
    r"|\b(?:lookup|query)\([ \t]*[\"'](?:ansible\.builtin\.)?(?:file|template)[\"'][ \t]*,(?![ \t]*[\"'])"
    r"|\bsrc=|\b(?:copy|template|synchronize|unarchive):[ \t]*"
    r"(?!\{[^{}\n]*\bsrc:[ \t]*[\"']?[\w./-]{1,200}\.\w{1,10}[\"']?[ \t]*[,}])[^ \t\n]",
    re.M,
)
"""What a task copies, where that is a whole folder or the name is made of parts."""
_LISTED = regex(r"^[ \t]*(?:loop|with_\w+):[ \t]*[\"']?\{\{[ \t]*(?P<name>\w+)", re.M)
"""A list that has a name."""
_GUIDE = regex(r"(?<!CHANGELOG)(?<!changelog)\.(?:md|rst|txt|adoc|json|html|conf|cfg)$")
_SIZE = 512 * 1024


def left_out_units(files: Files, units: Units) -> Iterator[Unit]:
    """The units that start at boot once they are installed, that lie where only the tasks of a role find them, and that
    nothing of the tree names but themselves."""
    for unit in units.judged:
        source = unit.where.source
        role = _FILE.match(source.name) if source.origin is None and not source.template else None
        if role is None or not unit.words("WantedBy", "Install") or "@" in unit.name:
            continue
        if _copies_by_name(files, role) and not _is_named(files, unit):
            yield unit


def _copies_by_name(files: Files, role: re.Match[str]) -> bool:
    """Whether a role has tasks, all that they copy has a name that somebody wrote, and none is that of a folder with
    the unit; nor does anything else copy the files of the role."""
    tasks = [source for source in files.of_kind("ansible") if source.name.startswith(f"{role['role']}/")]
    others = (source.text for source in files.of_kind("ansible", "shell-script") if source not in tasks)
    if not tasks or any(f"{role['name']}/files" in text for text in others):
        return False
    lists = {match["name"] for each in tasks for match in _LISTED.finditer(each.text)}
    if not all(any(_gives(source.text, name) for source in files.sources) for name in lists):
        return False
    folders = "|".join(map(re.escape, role["path"].split("/")[:-1])) or "files"
    named = rf"[\"']?(?:[\w./-]*/)?(?:{folders})/?[\"']?"
    whole = re.compile(rf"(?:\b(?:src|source|path):|^[ \t]*-|[\[,])[ \t]*{named}[ \t\r]*(?:[,}}\]]|$)", re.M)
    return not any(_EVERY.search(each.text) or _HIDDEN.search(each.text) or whole.search(each.text) for each in tasks)


def _gives(text: str, name: str) -> bool:
    """Whether a text says what a list holds."""
    return name in text and re.search(rf"^[ \t]*{re.escape(name)}:", text, re.M) is not None


def _is_named(files: Files, unit: Unit) -> bool:
    """Whether anything but the unit itself says its name."""
    stem = unit.name.rpartition(".")[0]
    name = re.compile(rf"(?<![\w-]){re.escape(stem)}(?![\w-])")
    own = {file.source for file in unit.files}
    guides = files.tree.pages(_GUIDE, _SIZE)
    texts = (source.text for source in files.sources if source not in own)
    return any(stem in text and name.search(text) for each in (texts, scripts_of(files.tree), guides) for text in each)
