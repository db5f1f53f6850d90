"""Packages of ROS: their manifests, and what reads them."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.dependencies.misspelt_builds import MisspeltBuild
    from bringup_lint.graph.dependencies.setup_settings import UnreadSetting
    from bringup_lint.model.package import Manifest
    from bringup_lint.parsers.package_grammar import tags_of_format
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Manifest",
    "MisspeltBuild",
    "UnreadSetting",
    "tags_of_format",
]
