"""The modes that tasks give to files and folders."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.ansible_tasks import tasks
from bringup_lint.source import Source

_MODULES = frozenset(
    "archive assemble blockinfile copy file get_url ini_file lineinfile replace template unarchive".split()
)


class FileMode(NamedTuple):
    """The mode that one module gives to its file or folder."""

    mode: Scalar
    settings: Mapping
    """All that the module is told."""

    @property
    def is_octal(self) -> bool:
        """Whether YAML leaves the digits as they are, or takes them for an octal number."""
        return bool(self.mode.style or self.mode.tag) or self.mode.value.startswith("0")


def file_modes(source: Source) -> Iterator[FileMode]:
    for task in tasks(source):
        for module in task.modules:
            mode = module.settings.scalar("mode") if isinstance(module.settings, Mapping) else None
            if mode is not None and module.name in _MODULES and isinstance(module.settings, Mapping):
                yield FileMode(mode, module.settings)
