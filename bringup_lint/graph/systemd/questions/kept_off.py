"""Units of which a play says that they do not start at boot."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.files import Files
from bringup_lint.source import Source

_MODULES = frozenset({"service", "systemd", "systemd_service"})


def kept_off(files: Files) -> frozenset[str]:
    """The names, without their suffix, of the services that tasks disable and none enables: somebody starts them."""
    said = [each for source in files.of_kind("ansible") if "enabled" in source.text for each in _said(source)]
    return frozenset(name for name, enabled in said if not enabled) - {name for name, enabled in said if enabled}


def _said(source: Source) -> Iterator[tuple[str, bool]]:
    from bringup_lint.model.yaml_node import Mapping
    from bringup_lint.parsers.ansible_tasks import tasks

    for task in tasks(source):
        for module in task.modules:
            settings = module.settings
            if module.name in _MODULES and isinstance(settings, Mapping):
                name, enabled = settings.scalar("name"), settings.scalar("enabled")
                if name is not None and enabled is not None and enabled.boolean is not None:
                    yield str(name.value).removesuffix(".service"), enabled.boolean
