"""Image names, and what builds an image: a compose service, a target of a bake file, or a build command."""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located


class ImageName(NamedTuple):
    """The parts of a reference such as ``ghcr.io/rover/base:1.2``."""

    repository: str
    """Without ``docker.io/`` and ``library/``, which may be left out."""
    tag: str
    """Empty when none is written; ``latest`` is meant then."""
    digest: str = ""

    @property
    def is_latest(self) -> bool:
        return not self.digest and self.tag in ("", "latest")


class ImageBuild(NamedTuple):
    """One build as a file of the tree writes it."""

    names: tuple[str, ...]
    """The tags that the image gets."""
    context: str
    dockerfile: str
    """A path relative to the context in compose and bake files, to the working folder in commands; may be empty."""
    target: str
    """The stage; empty for the last."""
    where: Located


def image_name(text: str) -> ImageName:
    name, _, digest = text.partition("@")
    for prefix in ("docker.io/", "index.docker.io/", "library/"):
        name = name.removeprefix(prefix)
    folder, slash, last = name.rpartition("/")
    last, _, tag = last.partition(":")
    return ImageName(folder + slash + last, tag, digest)
