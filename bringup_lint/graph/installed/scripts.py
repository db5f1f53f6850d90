"""The scripts of a tree and what they do, each read once."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.starters import STARTING
from bringup_lint.graph.files import Files
from bringup_lint.graph.image_builds import runs_in_image
from bringup_lint.graph.installed.script import Run
from bringup_lint.graph.installed.script import Written
from bringup_lint.graph.installed.script import runs
from bringup_lint.graph.memo import memo
from bringup_lint.pattern import regex
from bringup_lint.source import Source

KINDS = ("shell-script",)
_SILENT = frozenset(
    "echo printf journalctl service log id getent useradd adduser usermod groupadd addgroup chown chpasswd hostnamectl "
    "hostname".split()
)
_QUERIES = frozenset(("link", "cat", "is-enabled", "list-unit-files"))
_AT_BOOT = regex(r"^### BEGIN INIT INFO(?:\n#[^\n]*){0,20}\n# *Default-Start: *\S", re.M, "BEGIN INIT INFO")
"""The head of an init script (LSB 5.0, "Comment Conventions for Init Scripts") that has run levels."""
_PART = regex(r"\{\{ [^{}]* \}\}|\$\{\w+\}|\$\w+")
_ITSELF = regex(r"\$\{?(?:0|BASH_SOURCE)\b")
_STEP = r"^[ \t]*RUN[ \t](?:[^\n]*\\\n)*[^\n]*"
_NEXT = regex(r"&&|;|\|\|?")
_HANDLES = regex(
    r"\s*(?:RUN[ \t]+)?(?:--\S+\s+)*(?:\\\n\s*)?(?:sudo\s+)?(?:chmod|chown|sed|dos2unix|cp|mv|ln|install|touch)\s", re.I
)
"""A command of a step that does not run the script which it names."""
_ENTERS = regex(r"\b(?:on_|arch-)?chroot\b|\bsystemd-nspawn\b|\bvirt-customize\b|\bqemu-\w{1,20}-static\b")
"""What a script says that runs commands in the system of an image."""
_NAMING = regex(
    r"(?:\.(?:md|rst|txt|adoc|sh|bash|py|ya?ml|xml|toml|cfg|ini|conf|service|timer|path|socket|desktop|rules|launch|j2|in)"
    r"|(?:^|[/.])(?:rc\.local|crontab|xinitrc|xsession|xprofile|xstartup|autostart|bashrc|bash_aliases|bash_profile|profile)"
    r"|(?:package|tasks|devcontainer)\.json|(?:Make|Docker|Container|[jJ]ust|Proc)file[^/]*)$"
)
"""Files that may run a script, or tell people to."""
_NAME = regex(r"(?<![\w.+-])[\w.][\w.+-]*\w")
SIZE = 200_000
"""Characters of a script that is read for what it does."""


@dataclass(eq=False)
class Scripts:
    files: Files

    @memo
    def done(self, source: Source) -> list[Run | Written]:
        """What a script does; nothing for a template or a very long one."""
        usable = not source.template and len(source.text) <= SIZE
        read = self.files.parsed(lambda script: list(runs(script)), [source]) if usable else []
        return next(iter(read), [])

    def run(self, *names: str) -> Iterator[tuple[Source, Run]]:
        """The runs of the programs in all judged scripts."""
        for source in self._saying(*names):
            for did in self.done(source):
                if isinstance(did, Run) and did.name in names:
                    yield source, did

    def written(self, *parts: str) -> Iterator[tuple[Source, Written]]:
        """What judged scripts write to files, where their text has one of the parts."""
        for source in self._saying(*parts):
            for did in self.done(source):
                if isinstance(did, Written) and not did.refused:
                    yield source, did

    def refused(self) -> Iterator[tuple[Source, list[Written]]]:
        """What the shells of judged scripts may not open, by script."""
        for source in self._saying("sudo "):
            found = [did for did in self.done(source) if isinstance(did, Written) and did.refused]
            if found:
                yield source, found

    def is_for_image(self, source: Source) -> bool:
        """Whether a Dockerfile or compose file names the script, so that a container may run it."""
        return any(source.basename in each.text for each in self.files.of_kind("dockerfile", "compose"))

    @memo
    def sets_up_image(self, source: Source) -> bool:
        """Whether a script runs once while an image is built: a step of a Dockerfile or a devcontainer.json names it,
        or another script that runs commands in the system of an image."""
        if runs_in_image(source):
            return True
        name = source.basename
        step = re.compile(rf"{_STEP}{re.escape(name)}", re.M | re.I)
        return (
            any(name in each.text for each in self.files.of_kind("devcontainer"))
            or any(_runs_in_step(step, each.text) for each in self.files.of_kind("dockerfile") if name in each.text)
            or any(
                name in each.text and _ENTERS.search(each.text) and each is not source
                for each in self.files.of_kind("shell-script")
            )
        )

    def _saying(self, *parts: str) -> Iterator[Source]:
        for source in self.files.of_kind(*KINDS):
            if source.judged and any(part in source.text for part in parts):
                yield source

    def brings_unit(self, source: Source, name: str) -> bool:
        """Whether a script may make a unit or install what brings it: another command than those that start it names
        the unit, or a file of which a variable gives a part of the name."""
        stem = name.rpartition(".")[0].partition("@")[0].replace("_", "-")
        for did in self.done(source):
            words = [did.path] if isinstance(did, Written) else _speaking(did)
            if any(stem in word.replace("_", "-") or _fits(word, name) for word in words):
                return True
        return False

    def raises_itself(self, source: Source) -> bool:
        """Whether a script may start itself again as root: ``exec sudo "$0"``."""
        runs_of_root = (did for did in self.done(source) if isinstance(did, Run) and did.by_root)
        return any(_ITSELF.search(word) for run in runs_of_root for word in run.words[:2])

    def starts_by_itself(self, source: Source) -> bool:
        """Whether something of the tree runs the script, so that it may run at every boot: it names the file, or the
        name of the script is that of an entry point."""
        name = source.basename
        if name in ("rc.local", "entrypoint.sh") or "entrypoint" in name or "/init.d/" in f"/{source.name}":
            return True
        if source.matches(_AT_BOOT):
            return True
        starters = (each for kind in STARTING if kind not in KINDS for each in self.files.of_kind(kind))
        return any(name in each.text for each in starters)

    def is_named(self, source: Source) -> bool:
        """Whether a page or another file of the tree names the script."""
        return not self._naming.get(source.basename, set()) <= {source.absolute}

    @cached_property
    def _naming(self) -> dict[str, set[str]]:
        """Name of a script -> the files that may run it, or tell people to, and name it."""
        tree, names = self.files.tree, {source.basename for source in self.files.of_kind(*KINDS)}
        found: dict[str, set[str]] = {}
        starters = (source.absolute for source in self.files.of_kind(*STARTING))
        for path in dict.fromkeys((*tree.like(_NAMING), *starters)):
            for name in names.intersection(_NAME.findall(tree.head(path, SIZE))):
                found.setdefault(name, set()).add(path)
        return found


def _runs_in_step(step: re.Pattern[str], text: str) -> bool:
    """Whether a step of a Dockerfile names a script for more than to change its mode or its place."""
    last = (_NEXT.split(found[0])[-1] for found in step.finditer(text))
    return not all(map(_HANDLES.match, last))


def _speaking(run: Run) -> list[str]:
    """The words of a command that has to do with what it names, rather than start it or speak of it."""
    if run.name in _SILENT or (run.name == "systemctl" and _QUERIES.isdisjoint(run.words)):
        return []
    return [run.text(word) for word in run.words]


def _fits(path: str, unit: str) -> bool:
    """Whether a path with variables may be a file of a unit."""
    name = posixpath.basename(path)
    if not name.endswith(unit.rpartition(".")[2]) or not _PART.search(name):
        return False
    return re.fullmatch(".*".join(map(re.escape, _PART.split(name))), unit) is not None
