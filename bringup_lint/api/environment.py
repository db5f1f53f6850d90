"""The environment of processes: environment files and the variables of ROS 2."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.environment.conflicts import Different
    from bringup_lint.graph.environment.conflicts import Overridden
    from bringup_lint.graph.environment.conflicts import conflicts
    from bringup_lint.graph.environment.env_files import UsedEnvFile
    from bringup_lint.graph.environment.env_files import docker_env_files
    from bringup_lint.graph.environment.images import missing_middleware
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.environment.ros import Setting
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Different",
    "Overridden",
    "RosProcess",
    "Setting",
    "UsedEnvFile",
    "conflicts",
    "docker_env_files",
    "missing_middleware",
]
