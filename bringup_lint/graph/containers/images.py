"""Images: what the tree builds under which name, so that an image that it builds is known wherever it is named."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint import facts
from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.discover.tree import Tree
from bringup_lint.graph.memo import memo
from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import is_variable
from bringup_lint.model.dockerfile import VARIABLE
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.image_build import ImageBuild
from bringup_lint.model.image_build import ImageName
from bringup_lint.model.image_build import image_name
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers import bake
from bringup_lint.parsers import build_commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_BAKE = regex(r"(?:^|/)docker-bake(?:\.[\w-]+)?\.hcl$")
_COMMANDS = regex(
    r"(?:^|/)(?:(?:GNU)?[Mm]akefile|[Jj]ustfile|[^/]+\.(?:sh|bash|zsh|mk|md|rst|bat|ps1|py)|[^/.]*build[^/.]*"
    r"|\.github/workflows/[^/]+\.ya?ml|\.gitlab-ci\.yml)$"
)
_UNKNOWN = regex(r"[${<%]")
_MOST_FILES = 500
"""How many files are looked through for build commands."""


class Built(NamedTuple):
    """An image that the tree builds."""

    name: ImageName
    stage: Stage | None
    """None when its Dockerfile is not in the tree, or not known."""
    where: Located


@dataclass(eq=False)
class Images:
    """Which Dockerfile of the tree makes the image of a name."""

    tree: Tree
    dockerfiles: list[Dockerfile]
    compose_files: list[ComposeFile] = field(default_factory=list)

    @cached_property
    def built(self) -> dict[str, list[Built]]:
        """Every image that the tree builds, by its repository."""
        found: dict[str, list[Built]] = {}
        for build, asked_by in [*self._services(), *self._commands()]:
            stage = self._stage(build, asked_by)
            for text in build.names:
                name = _known(text)
                if name is not None:
                    found.setdefault(name.repository, []).append(Built(name, stage, build.where))
        return found

    @cached_property
    def computed(self) -> frozenset[str]:
        """The names, as they are written, of images that the tree builds and of which the repository is not known."""
        builds = (build for build, _ in [*self._services(), *self._commands()])
        return frozenset(text for build in builds for text in build.names if _known(text) is None)

    def is_built(self, image: str) -> bool:
        """Whether something of the tree builds an image of this repository."""
        return image_name(image).repository in self.built

    def is_named(self, dockerfile: Source) -> bool:
        """Whether a file that may hold build commands names a Dockerfile by its name, or by its folder and name."""
        name = dockerfile.basename
        if name in ("Dockerfile", "Containerfile"):
            name = "/".join(dockerfile.name.split("/")[-2:])
            if name == dockerfile.basename:
                return False
        written = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w.-])")
        return any(name in text and written.search(text) for text in self._build_texts)

    def is_target(self, stage: Stage) -> bool:
        """Whether a build of the tree ends with a stage: ``--target``, or ``target:`` of a workflow."""
        if stage.name is None:
            return False
        chosen = re.compile(rf"(?:--target[ =]|\btarget:[ \t]*)[\"']?{re.escape(stage.name)}(?![\w.-])")
        return any(stage.name in text and chosen.search(text) for text in self._build_texts)

    def is_chosen(self, stage: Stage, *, tag: bool) -> bool:
        """Whether a build of the tree may give another base to a stage than the default of an ARG says: another
        repository, or with ``tag`` another tag."""
        images = (each.image if tag else each.image.partition(":")[0] for each in stage.chain)
        named = {match["braced"] or match["plain"] for image in images for match in VARIABLE.finditer(image)}
        return any(self._is_given(name) for name in named)

    @memo
    def _is_given(self, argument: str) -> bool:
        """Whether a compose file, a bake file or a build command gives a value to an ARG."""
        if argument in self._build_arguments:
            return True
        given = re.compile(rf"\b{re.escape(argument)}[\"']?[ \t]*[:=]")
        return any("build" in text and "arg" in text and given.search(text) for text in self._build_texts)

    @cached_property
    def _build_arguments(self) -> frozenset[str]:
        services = (service for file in self.compose_files for service in file.services)
        return frozenset(name for service in services for name in service.build_arguments)

    @cached_property
    def _build_texts(self) -> list[str]:
        return [source.text for source in self.texts if not source.name.endswith((".md", ".rst"))]

    def stage(self, image: str) -> Stage | None:
        """The stage that an image is built from: of the same tag, else of the only build of its repository."""
        wanted = image_name(image)
        if wanted.digest:
            return None
        builds = self.built.get(wanted.repository, [])
        exact = [build for build in builds if (build.name.tag or "latest") == (wanted.tag or "latest")]
        stages = {build.stage for build in exact or builds}
        return next(iter(stages)) if len(stages) == 1 else None

    def missing_targets(self) -> Iterator[tuple[Located, Dockerfile]]:
        """The targets of compose services that are no stage of their Dockerfile."""
        for compose in self.compose_files:
            for build in (service.build for service in compose.services if not service.inline_dockerfile):
                if build is None or build.target is None or _UNKNOWN.search(f"{build.context}{build.dockerfile}"):
                    continue
                path = posixpath.join(str(build.context or "."), str(build.dockerfile or "Dockerfile"))
                file = self._dockerfile(compose.source, path)
                unknown = not _UNKNOWN.search(build.target) and not build.target.isdecimal()
                if file is not None and unknown and file.stages and file.stage(build.target) is None:
                    yield build.target, file

    def _services(self) -> Iterator[tuple[ImageBuild, Source]]:
        for file in self.compose_files:
            for service in file.services:
                build, image = service.build, service.image
                if build is not None and image is not None and not service.inline_dockerfile:
                    parts = (str(build.context or "."), str(build.dockerfile or ""), str(build.target or ""))
                    yield ImageBuild((str(image),), *parts, image), file.source

    def _commands(self) -> Iterator[tuple[ImageBuild, Source]]:
        for source in self.texts:
            parse = bake.parse if _BAKE.search(source.name) else build_commands.parse
            for build in parse(source):
                yield build, source

    @cached_property
    def texts(self) -> tuple[Source, ...]:
        """The files that may hold build commands and bake targets."""
        return tuple(self._texts())

    def _texts(self) -> Iterator[Source]:
        known = {source.name for source in self.tree.sources}
        yield from (source for source in self.tree.sources if source.kind == "shell-script")
        paths = (path for path in self.tree.paths if _BAKE.search(path) or _COMMANDS.search(path))
        for path in [path for path in paths if path not in known][:_MOST_FILES]:
            source = self.tree.read(path, judged=False)
            if source is not None and source.name not in known:
                yield source

    def _stage(self, build: ImageBuild, asked_by: Source) -> Stage | None:
        file = next((file for path in _candidates(build) if (file := self._dockerfile(asked_by, path))), None)
        if file is None or is_variable(build.target):
            return None
        return file.stage(build.target) if build.target else file.final

    def _dockerfile(self, asked_by: Source, path: str) -> Dockerfile | None:
        source = self.tree.beside(asked_by, path)
        return next((file for file in self.dockerfiles if file.source is source), None) if source else None


def _candidates(build: ImageBuild) -> Iterable[str]:
    """Where the Dockerfile may be, relative to the file that names it. A leading variable is the folder of a script."""
    context = _without_folder(build.context or ".")
    path = _without_folder(build.dockerfile or "Dockerfile")
    if _UNKNOWN.search(context) or _UNKNOWN.search(path) or "://" in context or path.startswith("/"):
        return ()
    found = [posixpath.join(context, path)]
    if build.dockerfile:
        found += [path, *(posixpath.join(up, path) for up in ("..", "../.."))]
    else:
        found += [posixpath.join(up, context, path) for up in ("..", "../..")]
    return found


def _without_folder(path: str) -> str:
    return re.sub(r"^\$(?:\{\w+\}|\(\w+\)|\w+)(?:/|$)", "./", path)


def _known(text: str) -> ImageName | None:
    """The name without a tag that is not known; None when the repository is not known."""
    name = image_name(text)
    if not name.repository or _UNKNOWN.search(name.repository):
        return None
    return name._replace(tag="") if _UNKNOWN.search(name.tag) else name


def link_bases(images: Images) -> None:
    """Let the stages of Dockerfiles build on images that other Dockerfiles of the tree build."""
    for file in images.dockerfiles:
        for stage in file.stages:
            if stage.base is None and "$" not in stage.resolved and stage.resolved != "scratch":
                base = images.stage(stage.resolved)
                if base is not None and stage not in base.chain:
                    stage.base = base


def can_be_pulled(image: str) -> bool:
    """Whether a registry may hold an image: without a namespace, only the official ones are there."""
    repository = image_name(image).repository
    return "/" in repository or repository in _official()


def _official() -> set[str]:
    return {row["image"] for row in facts.table("docker/official_images")}
