"""The functions and classes that the evaluator knows, by name."""

from __future__ import annotations

from bringup_lint.parsers.launch_python.actions import ACTIONS
from bringup_lint.parsers.launch_python.events import EVENTS
from bringup_lint.parsers.launch_python.functions import FUNCTIONS
from bringup_lint.parsers.launch_python.nodes import NODES
from bringup_lint.parsers.launch_python.state import Builder
from bringup_lint.parsers.launch_python.substitutions import SUBSTITUTIONS

LIBRARY: dict[str, Builder] = {
    **FUNCTIONS,
    **SUBSTITUTIONS,
    **ACTIONS,
    **NODES,
    **EVENTS,
}

LAUNCH_PACKAGES = frozenset(
    "launch launch_ros launch_xml launch_yaml launch_testing launch_testing_ros launch_pytest nav2_common".split()
)


def key(name: str) -> str:
    """How a full name is looked up: names of launch's packages by class, as each is exported in several modules."""
    package, _, rest = name.partition(".")
    if package == "ament_index_python":
        return "ament_index_python." + rest.rpartition(".")[2]
    if package not in LAUNCH_PACKAGES or not rest:
        return name
    modules, _, last = rest.rpartition(".")
    if "events" in modules.split("."):
        return "launch.events." + last
    if last == "Parameter":
        return "launch." + ("substitutions.Parameter" if "substitutions" in modules else last)
    return "launch." + last
