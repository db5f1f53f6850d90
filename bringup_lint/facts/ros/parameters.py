"""Parameters that libraries declare in the nodes that they are handed."""

from __future__ import annotations

from collections.abc import Iterable
from fnmatch import fnmatchcase
from functools import cache
from functools import lru_cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple

_MOST = 1000
"""Names of parameters that are known again: those of one robot repeat each other."""
OF_EVERY_NODE = ("use_sim_time", "start_type_description_service", "qos_overrides.*")
"""rclcpp and rclpy declare these themselves (rclcpp, time_source.cpp, node_type_descriptions.cpp, qos_overrides)."""

_OF_EVERY_CONTROLLER = ("type", "update_rate", "is_async", "thread_priority", "async_parameters.*", "params_file")
"""What the controller manager and the base class of controllers declare (ros2_control, controller_manager.cpp and
controller_interface_base.cpp)."""


class Names(NamedTuple):
    """Names and patterns of names. Most are no patterns: fnmatch would compile one of each, and forget those of long
    tables at once."""

    plain: frozenset[str]
    patterns: tuple[str, ...]

    def has(self, name: str) -> bool:
        return name in self.plain or any(fnmatchcase(name, pattern) for pattern in self.patterns)


def _names(written: Iterable[str]) -> Names:
    every = tuple(written)
    patterns = tuple(each for each in every if not set("*?[").isdisjoint(each))
    return Names(frozenset(every).difference(patterns), patterns)


def hands_parameters(package: str) -> bool:
    """Whether a package that is not in the tree may declare parameters in a node."""
    return not _without_parameters().has(package)


@cache
def _without_parameters() -> Names:
    return _names(row["package"] for row in table("ros/parameter_free"))


@lru_cache(_MOST)
def is_of_library(parameter: str) -> bool:
    """Whether the client library, or a common library, declares a parameter of this name."""
    return _of_libraries().has(parameter)


@cache
def _of_libraries() -> Names:
    named = (name for row in table("ros/parameter_free") for name in row["names"].split())
    return _names((*OF_EVERY_NODE, *named))


class PublicNode(NamedTuple):
    """A node of a public package, with the patterns of all parameters that it declares."""

    package: str
    names: frozenset[str]
    """The names that it has when nothing gives it another."""
    programs: frozenset[str]
    """Executables and component classes."""
    parameters: tuple[str, ...]

    @property
    def has_plugins(self) -> bool:
        """Whether plugins, of this package or another, declare parameters below their names."""
        return self.package.startswith("nav2_")

    @property
    def is_controller(self) -> bool:
        """Whether it is a controller of ros2_control, which the controller manager loads by its class."""
        return any("/" in program for program in self.programs)

    def declares(self, parameter: str) -> bool:
        if "." in parameter and self.has_plugins:
            return True
        if self.is_controller and _of_controllers().has(parameter):
            return True
        return _names_of(self.parameters).has(parameter) or is_of_library(parameter)

    @property
    def defaults(self) -> dict[str, object]:
        """The defaults of its parameters, as far as they are known."""
        import json

        return {
            row["parameter"]: json.loads(row["default"])
            for row in table("ros/parameter_defaults")
            if row["package"] == self.package
        }

    def type_of(self, parameter: str) -> str | None:
        """The type that the node declares for a parameter; None when it is not known."""
        subject, name = self.package, parameter
        if self.has_plugins:
            subject, name = "nav2", parameter.rpartition(".")[2]
        typed = (kind for package, names, kind in _typed() if package == subject and names.has(name))
        return next(typed, None)


@cache
def nav2_words() -> frozenset[str]:
    """The last parts of the names of all parameters of Navigation2, its plugins included."""
    return frozenset(word for row in table("ros/nav2_words") for word in row["words"].split())


@cache
def _of_controllers() -> Names:
    return _names(_OF_EVERY_CONTROLLER)


@cache
def _names_of(parameters: tuple[str, ...]) -> Names:
    return _names(parameters)


@cache
def _typed() -> tuple[tuple[str, Names, str], ...]:
    """Package, parameters and their type."""
    rows = table("ros/parameter_types")
    return tuple((row["package"], _names(row["parameters"].split()), row["type"]) for row in rows)


@cache
def public_nodes() -> tuple[PublicNode, ...]:
    return tuple(
        PublicNode(
            row["package"],
            frozenset(row["nodes"].split()),
            frozenset(row["executables"].split()),
            tuple(row["parameters"].split()),
        )
        for row in table("ros/node_parameters")
    )


def public_node(package: str, program: str) -> PublicNode | None:
    """The node that an executable or component class of a public package runs."""
    return next((each for each in public_nodes() if each.package == package and program in each.programs), None)


def controller_of(kind: str) -> PublicNode | None:
    """The controller of ros2_controllers that has a class, written as ``diff_drive_controller/DiffDriveController``."""
    return public_node(kind.partition("/")[0], kind) if "/" in kind else None


def node_called(name: str) -> PublicNode | None:
    """The node of a public package that has a name when nothing gives it another."""
    return next((each for each in public_nodes() if name in each.names), None)


def declared_by(package: str, executable: str) -> frozenset[str] | None:
    """All that a node of a public package declares, with ``zeros.`` for all below it; None when the table does not know
    it, or only by other patterns."""
    node = public_node(package, executable)
    names = [] if node is None else [each[:-1] if each.endswith(".*") else each for each in node.parameters]
    if node is None or node.has_plugins or any("*" in each for each in names):
        return None
    return frozenset(names)
