"""Units that scripts and plays of a tree install, and that nothing of it enables or starts."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial

from bringup_lint.graph.systemd.provision import scripts_of
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.source import Located
    from bringup_lint.source import Source

_BOOT = ("multi-user.target", "graphical.target", "default.target")
_PLACES = ("/etc/systemd/system/", "/lib/systemd/system/", "/usr/lib/systemd/system/")
_ANY = regex(
    r"\bsystemctl\b[^\n]{0,80}\b(?:enable|preset|reenable)\b[^\n]{0,200}[$*{%(\\]|\bpreset-all\b|\bdeb-systemd-helper\b"
    r"|^[ \t]*(?:-[ \t]*)?name:[ \t]*[\"']?\{\{[^\n]*\n(?:[ \t]+\w+:[^\n]*\n){0,4}[ \t]+enabled:"
    r"|\bEnableUnitFiles\b|[\"']enable[\"'][ \t]*,|\bSYSTEMD_SERVICE|\bdh_(?:installsystemd|systemd_enable)\b",
    re.M,
)
"""What may enable a unit without saying its name."""
_STARTING = regex(
    r"enabl|start|systemctl|(?<!\.)\bservice[ \t:]|preset|\.wants/|Wants=|Requires=|BindsTo=|Upholds=|Unit=|Also="
    r"|Service=|^[ \t]*(?:-[ \t]*)?name:|^[ \t]*-[ \t]*[\"']?[\w@.-]+[\"']?[ \t]*$",
    re.I,
)
"""Words of a line that has to do with the start of a unit that it names."""
_COPIES = regex(r"^[ \t]*(?:[\w$]*sudo\w*[ \t]+)?(?:cp|install|ln|mv|rsync)[ \t][^\n]*", re.M)
_NEXT = regex(r"[ \t](?:\|\|?|&&|#)|;")
"""What ends a command."""
_UNIT_FILE = regex(r"(?<![\w@.-])[\w.-]+\.(?:service|timer|socket|path)(?![\w.-])")
_GUIDE = regex(r"\.(?:md|rst|txt|adoc|ipynb|html)$")
_SIZE = 512 * 1024


def never_enabled_units(files: Files, units: Units) -> Iterator[Unit]:
    """The system units for the boot that a script or play puts into place by their name, where nothing of the tree
    enables, starts or needs them."""
    copied = {name for text in scripts_of(files.tree) if "/systemd/system" in text for name in _copied(text)}
    found = [unit for unit in units.judged if _is_installed(unit, copied)]
    if not found or any(map(_ANY.search, scripts_of(files.tree))):
        return
    named = _lines_of_starts(files, found)
    for unit in found:
        stem = re.compile(rf"(?<![\w-]){re.escape(_stem(unit))}(?![\w-])")
        own = {file.source for file in unit.files}
        if not any(source not in own and stem.search(line) for source, line in named):
            yield unit


def installed_at(files: Files, unit: Unit) -> Iterator[Located]:
    """Where a script of the tree puts the unit into place."""
    for source in files.of_kind("shell-script"):
        for start in source.once(_copies, partial(_copies, source)).get(unit.name, ()):
            at = source.text.index(unit.name, start)
            yield source.located(at, at + len(unit.name))


def _copies(source: Source) -> dict[str, list[int]]:
    """The units that a script puts into place, each with where the commands begin."""
    found: dict[str, list[int]] = {}
    if "/systemd/system" not in source.text:
        return found
    for match in _COPIES.finditer(source.text):
        for name in dict.fromkeys(_copied(match[0])):
            found.setdefault(name, []).append(match.start())
    return found


def _stem(unit: Unit) -> str:
    return unit.name.rpartition(".")[0]


def _copied(text: str) -> Iterator[str]:
    """The units that a script puts into the folder of the system's units, by their names."""
    for match in _COPIES.finditer(text):
        if "/systemd/system" in match[0]:
            command = _NEXT.split(match[0], maxsplit=1)[0]
            names = _UNIT_FILE.findall(command)
            yield from names[-1:] if command.rstrip("\"' \t").endswith(tuple(names)) else names


def _is_installed(unit: Unit, copied: set[str]) -> bool:
    """Whether a script or play installs a unit that is for the boot."""
    source = unit.where.source
    if unit.manager != "system" or "@" in unit.name or not any(w in _BOOT for w in unit.words("WantedBy", "Install")):
        return False
    written = source.origin is not None and (source.robot_path or "").startswith(_PLACES)
    return written or (unit.name in copied and source.judged)


def _lines_of_starts(files: Files, units: list[Unit]) -> list[tuple[Source | None, str]]:
    """The lines of the tree that name one of the units and have to do with starts."""
    stems = [_stem(unit) for unit in units]
    guides = ((None, page) for page in files.tree.pages(_GUIDE, _SIZE))
    scripts = ((None, text) for text in scripts_of(files.tree))
    sources = ((source, source.text) for source in files.sources)
    return [
        (source, line)
        for texts in (sources, scripts, guides)
        for source, text in texts
        if any(stem in text for stem in stems)
        for line in text.splitlines()
        if any(stem in line for stem in stems) and _STARTING.search(line)
    ]
