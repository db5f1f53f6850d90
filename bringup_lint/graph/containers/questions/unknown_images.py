"""Images without a namespace that Dockerfiles name, and that nobody has: no stage, no build here, no registry."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.containers.images import can_be_pulled
from bringup_lint.graph.memo import kept
from bringup_lint.model.image_build import image_name
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.containers.images import Images
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.dockerfile import Stage

_FROM = regex(r"--from=(?P<copied>[\w.:-]+)\Z|--mount=(?:[^,]+,){0,9}from=(?P<mounted>[\w.:-]+)(?:,.*)?\Z")
_PLAIN = regex(r"[A-Za-z][\w.-]*(?::[\w.-]+)?")
_OF_STAGES = regex(
    r"base|build(?:er)?(?:[_-]\w+)?|deps|dependencies|dev|devel|development|final|prod|production|release|runtime|source|test"
)
"""Names that people give to stages, and that stand for other things in scripts and pages."""
_SPEAKS = regex(r"docker|podman|buildah|nerdctl|\btags?\b|(?:^|\s)-t\s|image|contexts?\b|target", re.I)
"""What a line that makes an image, or lends its name to one, has beside the name."""
_OTHERS = regex(
    r"(?i)(?:\.(?:adoc|txt|ya?ml|toml|json|env|cfg|conf|ini|tf|gradle|groovy|cmake|j2)"
    r"|(?:^|/)(?:Jenkinsfile|Earthfile|Tiltfile|Vagrantfile|CMakeLists\.txt|\.env[^/]*))$"
)
"""More files that may name what is built somewhere."""
_SIZE = 200_000
_WORD = regex(r"[\w.-]+")
_MANY = 100
"""Computed names, among which any may be."""
_COMPUTED = regex(
    r"\$\{[^}]{0,80}\}|\$\$?\([^)]{0,80}\)|\$\w+|\$[@<*?]|\{\{[^}]{0,80}\}\}|\{[^}]{0,80}\}|%\w%?|<[^>]{0,80}>"
)


class UnknownImage(NamedTuple):
    where: Located
    name: str
    last: Located | None
    """The FROM of the stage above."""


def unknown_images(compose: Compose) -> Iterator[UnknownImage]:
    """The first place of each name in a file."""
    for file in compose.images.dockerfiles:
        if file.source.judged:
            yield from _of_file(compose, file)


def _of_file(compose: Compose, file: Dockerfile) -> Iterator[UnknownImage]:
    above: set[str] = set()
    seen = {"scratch"}
    last: Located | None = None
    for stage in file.stages:
        for place in _named(stage):
            name = image_name(place).repository
            if name in seen or place.lower() in above or not _PLAIN.fullmatch(place):
                continue
            seen.add(name)
            if not can_be_pulled(name) and not _known(compose).has(name):
                yield UnknownImage(place, name, last)
        if stage.name is not None:
            above.add(stage.name.lower())
        last = stage.start.keyword


def _named(stage: Stage) -> Iterator[Located]:
    yield stage.image
    for flag in (flag for instruction in stage.all("COPY", "ADD", "RUN") for flag in instruction.flags):
        if match := _FROM.match(flag):
            yield flag.part(*match.span(match.lastgroup or 0))


@kept
def _known(compose: Compose) -> _Known:
    return _Known(compose)


class _Known:
    """What files of the tree may make, or give as a build context."""

    def __init__(self, compose: Compose) -> None:
        self._images = compose.images
        self._services = _of_services(self._images)
        self._computed = set(self._images.computed)
        has_bake = any(path.endswith(".hcl") for path in compose.tree.paths)
        files = self._images.dockerfiles if has_bake else ()
        self._stages = {str(stage.name).lower() for file in files for stage in file.stages if stage.name is not None}
        """A bake file may give the stages of one file to another."""
        self._words: set[str] = set()
        self._spoken: set[str] = set()
        """The words of lines that speak of images."""
        for text in _texts(compose):
            self._words.update(_WORD.findall(text.lower()))
            self._spoken.update(
                word for line in text.splitlines() if _SPEAKS.search(line) for word in _WORD.findall(line.lower())
            )

    def has(self, name: str) -> bool:
        if self._images.is_built(name) or name.endswith(self._services) or name.lower() in self._stages:
            return True
        if name.lower() in (self._spoken if _OF_STAGES.fullmatch(name) else self._words):
            return True
        return len(self._computed) > _MANY or any(_may_mean(computed, name) for computed in self._computed)


def _may_mean(computed: str, name: str) -> bool:
    """Whether a name of which parts are computed may be this one."""
    first, *inner = image_name(_COMPUTED.sub("*", computed.lower())).repository.split("*")
    left = name.lower()
    if not inner or not left.startswith(first) or not left.endswith(inner[-1]):
        return False
    left = left[len(first) :]
    for part in inner[:-1]:
        at = left.find(part)
        if at < 0:
            return False
        left = left[at + len(part) :]
    return len(left) >= len(inner[-1])


def _of_services(images: Images) -> tuple[str, ...]:
    """The ends of the names that compose gives to the images which it builds: behind that of the project."""
    services = (service for file in images.compose_files for service in file.services)
    names = [str(service.name).lower() for service in services if service.build is not None and service.image is None]
    return tuple(f"{sign}{name}" for name in names for sign in "-_")


def _texts(compose: Compose) -> Iterator[str]:
    yield from (source.text for source in compose.images.texts)
    yield from compose.tree.pages(_OTHERS, _SIZE)
    yield from (source.text for source in compose.tree.sources if source.kind in ("compose", "devcontainer"))
