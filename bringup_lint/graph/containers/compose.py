"""Compose files joined to what they name: env files and Dockerfiles."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.containers.images import Images
from bringup_lint.graph.containers.images import link_bases
from bringup_lint.graph.memo import memo
from bringup_lint.model.compose import ComposeFile
from bringup_lint.model.compose import Service
from bringup_lint.model.compose import is_variable
from bringup_lint.model.dockerfile import Stage
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.parsers.compose import parse
from bringup_lint.parsers.dockerfile import parse as parse_dockerfile
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.files import Files
    from bringup_lint.model.dockerfile import Dockerfile


@dataclass(eq=False)
class Compose:
    """Every compose file of the tree. Each stands alone: what is combined only the command line knows."""

    tree: Tree
    read_dockerfiles: Callable[[], list[Dockerfile]]
    files: list[ComposeFile] = field(default_factory=list)

    @property
    def services(self) -> Iterator[Service]:
        """The services of all files; of templates, whose text is not final, none."""
        for file in self.files:
            if not file.source.template:
                yield from file.services

    def services_called(self, name: str) -> list[Service]:
        """The services of one name: those of several files may be one that is put together."""
        return self._by_name.get(name, [])

    def is_set_elsewhere(self, service: Service, *keys: str) -> bool:
        """Whether another service of the same name, which may be the same one in another file, sets one of these
        keys."""
        return any(each is not service for key in keys for each in self._setting((str(service.name), key)))

    @memo
    def _setting(self, name_and_key: tuple[str, str]) -> list[Service]:
        name, key = name_and_key
        return [each for each in self.services_called(name) if each.get(key) is not None]

    @cached_property
    def _by_name(self) -> dict[str, list[Service]]:
        found: dict[str, list[Service]] = {}
        for service in self.services:
            found.setdefault(str(service.name), []).append(service)
        return found

    @property
    def whole_services(self) -> Iterator[Service]:
        """The services that say what they run: only of these can something be missing."""
        return (service for service in self.services if service.is_whole and not self.extends_elsewhere(service))

    @property
    def unprivileged_services(self) -> Iterator[Service]:
        """Those that the kernel may restrict; ``privileged: true`` takes every restriction back."""
        return (service for service in self.whole_services if not service.is_privileged)

    def remarks(self, *codes: Code) -> Iterator[Remark]:
        """What docker compose objects to in the files; of templates, whose text is not final, nothing."""
        for file in self.files:
            if not file.source.template:
                yield from (remark for remark in file.remarks if remark.code in codes)

    @staticmethod
    def extends_elsewhere(service: Service) -> bool:
        """Part of the service is in another file."""
        extended: Service | None = service
        while extended is not None and extended.base is not None:
            extended = extended.base
        return extended is not None and extended.body.get("extends") is not None

    def env_files(self, service: Service) -> list[Source]:
        """The env files of a service that are in the tree, the later ones winning."""
        paths = (path for path in service.env_files if not is_variable(path))
        found = (self.tree.beside(service.source, path) for path in paths)
        return [source for source in found if source is not None]

    def variables(self, service: Service, *names: str) -> list[tuple[str, Located]]:
        """The values of these variables in the order of the names: ``environment`` wins over env files."""
        found = []
        for name in names:
            own = service.environment.get(name)
            if own is not None and own.value is not None:
                found.append((name, own.value))
            elif own is None:
                lines = (value for source in self.env_files(service) for value in _assigned(source, name))
                found += [(name, value) for value in list(lines)[-1:]]
        return found

    @memo
    def stage(self, service: Service) -> Stage | None:
        """The stage that the service's image is built from, when its Dockerfile is in the tree: its own, or that of
        whatever else in the tree builds an image of this name."""
        build = service.build
        if build is None:
            image = service.image
            return self.images.stage(image) if image is not None and not is_variable(image) else None
        if service.inline_dockerfile or any(part is not None and is_variable(part) for part in build):
            return None
        path = f"{build.context or '.'}/{build.dockerfile or 'Dockerfile'}"
        source = self.tree.beside(service.source, path)
        file = next((file for file in self.images.dockerfiles if file.source is source), None)
        if file is None:
            return None
        return file.stage(build.target) if build.target else file.final

    @cached_property
    def images(self) -> Images:
        """What the tree builds; the stages of its Dockerfiles know their bases in other Dockerfiles then."""
        images = Images(self.tree, self.read_dockerfiles(), self.files)
        link_bases(images)
        return images

    def users(self, stage: Stage) -> list[Service]:
        """The services that run the image of a stage."""
        return self._users.get(stage, [])

    @cached_property
    def _users(self) -> dict[Stage | None, list[Service]]:
        users: dict[Stage | None, list[Service]] = {}
        for service in self.services:
            users.setdefault(self.stage(service), []).append(service)
        return users

    @cached_property
    def by_folder(self) -> dict[str, list[ComposeFile]]:
        """Folder -> its compose files."""
        found: dict[str, list[ComposeFile]] = {}
        for file in self.files:
            found.setdefault(os.path.dirname(file.source.name), []).append(file)
        return found

    @cached_property
    def build_folders(self) -> frozenset[str]:
        """The folders of the Dockerfiles of which the tree makes images, and those that services build them from."""
        built = [file for file in self.images.dockerfiles if not self.built_stages.isdisjoint(file.stages)]
        found = {os.path.dirname(file.source.name) for file in built}
        for service in (service for file in built for stage in file.stages for service in self.users(stage)):
            if service.build is not None:
                beside = os.path.dirname(service.source.name)
                context = os.path.normpath(os.path.join(beside, str(service.build.context or ".")))
                found.add(context.removeprefix("."))
        return frozenset(found)

    @cached_property
    def built_stages(self) -> frozenset[Stage | None]:
        """The stages that services and build commands of the tree make images of."""
        return frozenset(self._users) | {built.stage for group in self.images.built.values() for built in group}


def _assigned(source: Source, name: str) -> Iterator[Located]:
    """The values that an env file gives to a variable."""
    for match in re.finditer(rf"^[ \t]*(?:export[ \t]+)?{re.escape(name)}=(.*?)[ \t\r]*$", source.text, re.M):
        yield source.located(match.start(1), match.end(1))


def load_compose(files: Files) -> Compose:
    def dockerfiles() -> list[Dockerfile]:
        return files.parsed(parse_dockerfile, [each for each in files.of_kind("dockerfile") if not each.template])

    return Compose(files.tree, dockerfiles, files.parsed(parse, files.of_kind("compose")))
