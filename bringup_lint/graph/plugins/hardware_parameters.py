"""The parameters that descriptions give to hardware of ros2_control, compared with what its source reads."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from functools import partial
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.endings import CPP
from bringup_lint.graph.plugins.xacro_values import XacroValues
from bringup_lint.model.cpp_text import end_of_block
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.model.xml import Element

_EXPORTS = regex(
    r"\bPLUGINLIB_EXPORT_CLASS\s{0,4}\(\s{0,40}(?:\w{1,80}::){0,4}(?P<class>\w{1,80})\s{0,4},\s{0,40}"
    r"hardware_interface::(?:System|Actuator|Sensor)Interface\b"
)
_ON_INIT = regex(r"\bon_init\s{0,4}\([^;{}()]{0,300}\)(?:\s{0,4}(?:override|noexcept|final)){0,2}\s{0,40}\{")
_NEEDED = regex(
    r"\bsto(?:i|l|ul|ll|f|d)\s{0,4}\(\s{0,40}(?:[\w.>()-]{0,60}(?:\.|->))?hardware_parameters\s{0,4}"
    r"(?:\[|\.\s{0,4}at\s{0,4}\()\s{0,40}\"(?P<turned>[\w.-]{1,80})\""
    r"|\bhardware_parameters\s{0,4}\.\s{0,4}at\s{0,4}\(\s{0,40}\"(?P<taken>[\w.-]{1,80})\""
)
"""Reads that raise an exception when the description does not give the parameter, as ``std::stoi`` of nothing does."""
_READ = regex(r"\bhardware_parameters\s{0,4}(?:\[|\.\s{0,4}\w{2,10}\s{0,4}\()\s{0,40}\"(?P<name>[\w.-]{1,80})\"")
_OF_JOINT = regex(r"\bparameters\s{0,4}(?:\[|\.\s{0,4}\w{2,10}\s{0,4}\()\s{0,40}\"(?P<name>[\w.-]{1,80})\"")
_TRUE = regex(
    r"\bhardware_parameters\s{0,4}(?:\[|\.\s{0,4}at\s{0,4}\()\s{0,40}\"(?P<name>[\w.-]{1,80})\"\s{0,4}[\])]\s{0,4}"
    r"==\s{0,40}\"(?P<word>[Tt]rue|1)\""
)
_HANDED_ON = regex(
    r"\bhardware_parameters\s{0,4}(?:[),;]|\.\s{0,4}c?begin\b)|(?<!on_init)\(\s{0,4}info_?\s{0,4}[,)]|,\s{0,4}info_?\s{0,4}[,)]"
)
"""What gives all parameters to something else."""
_COMPUTED = regex(
    r"\bhardware_parameters\s{0,4}(?:\[|\.\s{0,4}\w{2,10}\s{0,4}\()\s{0,40}"
    r"(?:\"[\w.-]{0,80}\"\s{0,40}\+|[^\"\s\])][^\"\])]{0,80}?(?:\+|::|\.|->))"
)
"""A name that the source puts together, or takes from elsewhere."""
_PLAINLY = regex(
    r"\bhardware_parameters\s{0,4}(?:\[|\.\s{0,4}at\s{0,4}\()\s{0,40}\"(?P<name>[\w.-]{1,80})\"(?!\s{0,4}\]\s{0,4}=[^=])"
)
"""What takes a parameter for given, in distinction to what looks for it or sets it."""
_KEPT = regex(r"\b(\w{1,80})\s{0,9}=\s{0,9}\(?\s{0,9}(?:\w{1,80}(?:\.|->)){0,4}hardware_parameters\W[^=;]*\Z")
_BEFORE = 300
_TEXT = regex(r'"(?:\\.|[^"\\\n])*"')
_SET = regex(r"\bhardware_parameters\s{0,4}\[\s{0,40}\"(?P<name>[\w.-]{1,80})\"\s{0,4}\]\s{0,4}=[^=]")
_LEAVES = regex(r"\btry\b|\breturn\b[^;]{0,80}\b(?:SUCCESS|OK)\b|^[ \t]*#[ \t]*if", re.M)
"""What handles an exception, ends ``on_init`` well before its end, or is not compiled everywhere."""
_CONDITION = regex(r"\s*(?:if|else|for|while|case|switch)\b|[^;{}]*\?")
_QUOTED = regex(r"\"([\w./-]{1,80})\"")
_JOINTS = "_.-"
"""What is between the parts of a name."""
_PLAIN = frozenset({"plugin", "param", "if", "unless", "group"})
"""Elements of hardware that hide no parameters."""
_VALUE = regex(r"\$\{\s*(?:(?P<name>[A-Za-z_]\w*)|[A-Za-z_]\w*(?:\[['\"]\w+['\"]\])*\[['\"](?P<key>\w+)['\"]\])\s*\}\Z")


_MOST = 300
"""Places of one source that are looked at."""


class HardwareParameter(NamedTuple):
    kind: str
    """``missing``, ``unread`` or ``boolean``."""
    name: str
    place: Span
    """The plugin, the name of the parameter, or its value."""
    plugin: str
    read: Span
    """Where the source reads it, or its parameters."""
    others: tuple[str, ...] = ()
    """Further ones that are missing."""
    like: str | None = None
    """What the source reads, and the description does not give."""
    value: Span | None = None
    """Where the value comes from."""
    is_idle: bool = False
    """Nothing uses what the source keeps of it."""


class Driver(NamedTuple):
    """The source of a class of hardware."""

    source: Source
    plain: str
    """Its text, with blanks for comments."""


def hardware_parameters(files: Files) -> Iterator[HardwareParameter]:
    drivers = _drivers(files)
    if not drivers:
        return
    roots = [(each, root) for each in files.of_kind("urdf") if (root := parse(each).root) is not None]
    values = XacroValues()
    for _, root in roots:
        values.take(root)
    quoted = _quoted(files)
    for source, root in roots:
        if source.judged and not source.template:
            for plugin in [each for each in root.walk() if each.local == "plugin"]:
                driver = drivers.get(str(plugin.text).strip().replace("::", "/").rpartition("/")[2])
                hardware = _around(plugin, "hardware")
                if driver is not None and hardware is not None:
                    yield from _missing(driver, plugin, hardware)
                    yield from _unread(driver, plugin, hardware, quoted)
                    yield from _boolean(driver, plugin, values, files)


def _drivers(files: Files) -> dict[str, Driver]:
    """Class -> its source, for classes that one source exports, and no other beside them."""
    found: dict[str, list[Source]] = {}
    for source in files.of_kind("cpp-node"):
        classes = set(_EXPORTS.findall(source.text)) if "hardware_parameters" in source.text else set()
        for name in classes:
            found.setdefault(name, []).extend([source] * len(classes))
    single = {name: sources[0] for name, sources in found.items() if len(sources) == 1}
    return {name: Driver(each, plain_of(each)) for name, each in single.items()}


def _quoted(files: Files) -> frozenset[str]:
    """The words that stand as texts in any C++ source of the tree."""
    paths = (path for path in files.tree.paths if path.endswith(CPP))
    sources = (files.tree.read(path, judged=False) for path in paths)
    return frozenset(word for source in sources if source is not None for word in _QUOTED.findall(source.text))


def _beside(plugin: Element) -> list[Element]:
    """The parameters that stand under the same condition as a plugin."""
    return [each for each in plugin.parent.children if each.local == "param"] if plugin.parent is not None else []


def _around(element: Element, local: str) -> Element | None:
    return next((each for each in element.ancestors if each.local == local), None)


def _missing(driver: Driver, plugin: Element, hardware: Element) -> Iterator[HardwareParameter]:
    """Parameters that ``on_init`` cannot do without."""
    below = [each for each in hardware.walk() if each is not hardware]
    given = [str(each.get("name")) for each in below if each.local == "param"]
    if any(each.local not in _PLAIN for each in below) or any("$" in name for name in given):
        return
    needed = {name: span for name, span in _needed(driver) if name not in given}
    if needed:
        first, *others = needed
        yield HardwareParameter("missing", first, plugin.text.span, _name(plugin), needed[first], tuple(others))


def _needed(driver: Driver) -> Iterator[tuple[str, Span]]:
    bodies = [(each.end(), end_of_block(driver.plain, each.end())) for each in _ON_INIT.finditer(driver.plain)]
    if len(bodies) != 1:
        return  # of several classes
    start, end = bodies[0]
    body = driver.plain[start:end]
    if _LEAVES.search(body, 0, max(0, body.rfind("return"))):
        return
    taken = Counter(_PLAINLY.findall(driver.plain))
    for match in islice(_NEEDED.finditer(body), _MOST):
        name = match["turned"] or match["taken"]
        before = body[: match.start()]
        statement = before[max(before.rfind(each) for each in ";{}") + 1 :]
        is_looked_up = driver.plain.count(f'"{name}"') > taken[name]
        if before.count("{") == before.count("}") and not _CONDITION.match(statement) and not is_looked_up:
            yield name, driver.source.span(start + match.start(), start + match.end())


def _unread(driver: Driver, plugin: Element, hardware: Element, quoted: frozenset[str]) -> Iterator[HardwareParameter]:
    """Parameters beside a plugin that no source of the tree names."""
    reads, joint = (list(islice(each.finditer(driver.plain), _MOST)) for each in (_READ, _OF_JOINT))
    plugins = {str(each.text).strip() for each in hardware.walk() if each.local == "plugin"}
    handed_on = _HANDED_ON.search(driver.plain) or _COMPUTED.search(driver.plain)
    if not reads or handed_on or (plugin.parent is hardware and len(plugins) > 1):
        return
    system = hardware.parent or hardware
    given = {str(each.get("name")) for each in system.walk() if each.local == "param"}
    for each in _beside(plugin):
        name = each.get("name")
        if name is not None and "$" not in name and str(name) not in quoted and not _is_joined(str(name), quoted):
            meant = next((match for match in (*reads, *joint) if _is_like(str(name), match["name"], given)), None)
            where = driver.source.span(*(meant or reads[0]).span("name"))
            like = meant["name"] if meant is not None else None
            yield HardwareParameter("unread", str(name), name.span, _name(plugin), where, like=like)


def _is_joined(name: str, quoted: frozenset[str]) -> bool:
    """Whether a source has the begin or the end of a name, to which it may join the rest."""
    cuts = [at for at, sign in enumerate(name) if sign in _JOINTS]
    return any(name[at:] in quoted or name[: at + 1] in quoted for at in cuts)


def _is_like(name: str, read: str, given: set[str]) -> bool:
    """Whether a name that a description does not give may be meant by one that it gives."""
    one, other = set(name.lower().split("_")), set(read.lower().split("_"))
    return read not in given and (one <= other or other <= one or bool(nearest(name, [read], 3)))


def _boolean(driver: Driver, plugin: Element, values: XacroValues, files: Files) -> Iterator[HardwareParameter]:
    """Truth values that xacro writes as Python does, and that the source compares with a word in small letters."""
    compared: dict[str, set[str]] = {}
    places = {}
    set_anew = set(_SET.findall(driver.plain))
    for match in _TRUE.finditer(driver.plain):
        compared.setdefault(match["name"], set()).add(match["word"])
        places[match["name"]] = driver.source.span(match.start("name"), match.end())
    for each in _beside(plugin):
        name = str(each.get("name"))
        if "true" in compared.get(name, ()) and "True" not in compared[name] and name not in set_anew:
            value = _written_true(each, values, files)
            if value is not None:
                idle = _is_idle(driver, places[name], files)
                yield HardwareParameter(
                    "boolean", name, each.text.span, _name(plugin), places[name], value=value, is_idle=idle
                )


def _is_idle(driver: Driver, place: Span, files: Files) -> bool:
    """Whether a source keeps what it reads in a variable that no C++ source of the tree uses."""
    kept = _KEPT.search(driver.plain[max(0, place.start - _BEFORE) : place.start])
    if kept is None:
        return False
    used = re.compile(rf"(?<!bool )\b{re.escape(kept[1])}\b(?!\s{{0,9}}=[^=])")
    paths = (path for path in files.tree.paths if path.endswith(CPP))
    sources = (files.tree.read(path, judged=False) for path in paths)
    named = (source for source in sources if source is not None and kept[1] in source.text)
    return not any(used.search(each.once(_TEXT, partial(_code, each))) for each in named)


def _code(source: Source) -> str:
    """A C++ source without its comments and texts."""
    return _TEXT.sub("", plain_of(source))


def _written_true(parameter: Element, values: XacroValues, files: Files) -> Span | None:
    """Where a value comes from that xacro writes as ``True``."""
    text = str(parameter.text).strip()
    match = _VALUE.match(text)
    if text == "True":
        return parameter.text.span
    if match is None:
        return None
    if match["name"]:
        return parameter.text.span if {"true", "True"} & values.names(text, parameter) else None
    return _true_in_yaml(match["key"], files)


def _true_in_yaml(key: str, files: Files) -> Span | None:
    """A file that gives a key of this name the value true, where descriptions load YAML."""
    if not any("load_yaml" in each.text for each in files.of_kind("urdf")):
        return None
    line = re.compile(rf"^[ \t-]*{re.escape(key)}[ \t]*:[ \t]+(?:true|True|TRUE)[ \t]*(?:#.*)?$", re.M)
    for path in files.tree.paths:
        source = files.tree.read(path, judged=False) if path.endswith((".yaml", ".yml")) else None
        found = line.search(source.text) if source is not None and key in source.text else None
        if source is not None and found is not None:
            return source.span(found.start() + len(found[0]) - len(found[0].lstrip(" \t-")), found.end())
    return None


def _name(plugin: Element) -> str:
    return str(plugin.text).strip()
