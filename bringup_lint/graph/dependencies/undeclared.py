"""What a package needs and does not declare, and how much it lacks where only declared packages are installed."""

from __future__ import annotations

import re
from enum import IntEnum
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.brought import brought_by
from bringup_lint.facts.ros.brought import is_released
from bringup_lint.facts.ros.brought import lists
from bringup_lint.facts.ros.needed import COMMON
from bringup_lint.facts.ros.needed import base
from bringup_lint.facts.ros.needed import of_ros_base
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.dependencies.needs import Need
from bringup_lint.graph.launch.packages import comes_with
from bringup_lint.graph.launch.packages import is_known_package
from bringup_lint.graph.launch.packages import package_like
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.dependencies.dependencies import Dependencies
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package

AT_RUN_TIME = ("exec_depend", "run_depend", "depend")
_PLACEHOLDER = regex(r"^(?:your|my)_(?:package|pkg|robot|node)|package_name$")
_BARE = regex(
    r"<!--\s{0,20}<(?:exec_|run_)?depend\b[^<>]{0,80}>\s{0,20}([\w-]{1,80})\s{0,20}</\w{1,20}>\s{0,20}-->", hints="<!--"
)
"""A dependency that is commented out, without a word on why."""
_EXPLAINED = regex(r"<!--\s{0,20}\w[^<>]{0,300}<(?:exec_|run_)?depend\b", hints="<!--")
"""A dependency in a comment after words, which say why it and others are left out."""
_WORD = regex(r"[A-Za-z][\w-]*")
_OF_LAUNCH = frozenset(("launch", "launch_ros", "launch_xml", "launch_yaml", "ament_index_python"))
"""What launch itself brings to all launch files."""
_BRING_LAUNCH = _OF_LAUNCH | {"ros2launch", "rclpy"}
_BUILD_TOOLS = ("ament_cmake", "ament_lint", "rosidl_cmake", "rosidl_typesupport")
_OF_TESTS = {
    "ament_cmake_gmock": ("ament_cmake_auto", "ament_cmake_ros", "ament_cmake_test"),
    "ament_cmake_gtest": ("ament_cmake_auto", "ament_cmake_gmock", "ament_cmake_ros"),
    "ament_cmake_pytest": ("ament_cmake_ros",),
    "ament_lint_auto": (),
}
"""What tests look for with CMake, and what brings it."""
_MESSAGES = ("_msgs", "_interfaces")
_METAPACKAGES = frozenset(("common_interfaces", "ros_core", "ros_base", "desktop", "desktop_full"))
"""What people declare for the messages that it brings (common_interfaces/package.xml; REP 2001)."""
_STARTED = ("node", "include")
_NAMED = (*_STARTED, "share", "description")
_TRIAL = regex(r"test|sim|gazebo|template")
"""Launch files that somebody starts to try something."""
_SEVERAL = 2
_DECORATION = regex(r"^(?:lib|python3?-)|-dev$")
_VIEWER = regex(r"^(?:rviz|rqt|plotjuggler)|_gui$")


class Lack(IntEnum):
    """What is there without it, the worst first."""

    BUILD = 0
    """CMake asks for a package of the same workspace, and a clean build stops."""
    NOWHERE = 1
    """Nothing of the tree brings it."""
    PACKAGE = 2
    """It is a package of the workspace, or one that ros-base lacks."""
    BASE = 3
    """It is there where ros-base is, or by what brings it."""
    OPTIONAL = 4
    """Launch files start it when an argument is passed."""
    ASIDE = 5
    """Only what is installed for a simulator or as an example needs it."""
    BROUGHT = 6
    """It comes with something that is declared, with the launch files, or with ros-base."""
    LIKELY = 7
    """It may come with something that is declared, the tree installs it otherwise, or CMake only looks for it."""


class Undeclared(NamedTuple):
    lack: Lack
    """The worst."""
    needs: list[Need]
    """The worst first."""
    others: list[Need]
    """Those that are likely there, or not always needed, where others are that are."""
    is_plain: bool
    """Whether a fresh build or robot lacks something, or several are left to others."""


def undeclared(dependencies: Dependencies, launch: Launch, package: Package) -> Undeclared | None:
    """None when nothing is to be said of the package."""
    needed = _Needed(dependencies, launch, package)
    lacks = [(lack, need) for need in dependencies.undeclared(package) if (lack := needed.lack(need)) is not None]
    if _EXPLAINED.search(package.manifest.source.text):
        lacks = [each for each in lacks if each[0] < Lack.PACKAGE]
    lacks.sort(key=lambda each: (each[0], needed.is_unclear(each[1]), _VIEWER.search(each[1].name) is not None))
    worst = lacks[0][0] if lacks else Lack.LIKELY
    if worst is Lack.LIKELY:
        return None
    certain = max(worst, Lack.BASE)
    least = Lack.LIKELY if certain is Lack.BASE else Lack.BROUGHT
    needs = [need for lack, need in lacks if lack <= certain]
    others = [need for lack, need in lacks if certain < lack <= least]
    is_used = len(needs) >= _SEVERAL or any(need.use != "module" for need in needs) or not _runs_with(package)
    return Undeclared(worst, needs, others, worst < Lack.BASE or (worst is Lack.BASE and is_used))


def _runs_with(package: Package) -> list[str]:
    """What a package declares for when it runs."""
    return [str(name) for tag, name in package.manifest.depends if tag in AT_RUN_TIME]


class _Needed:
    """One package, and what comes with its dependencies."""

    def __init__(self, dependencies: Dependencies, launch: Launch, package: Package) -> None:
        self._dependencies = dependencies
        self._launch = launch
        self._package = package

    @cached_property
    def _declared(self) -> frozenset[str]:
        return frozenset(map(str, self._launch.workspace.required(self._package)))

    @cached_property
    def _brought(self) -> frozenset[str]:
        return brought_by(self._declared)

    @cached_property
    def _own(self) -> frozenset[str]:
        return frozenset(str(name) for _, name in self._package.manifest.depends)

    @cached_property
    def _of_own_launch(self) -> frozenset[str]:
        """What the packages of launch bring that the package declares itself."""
        return brought_by(self._own & _BRING_LAUNCH)

    @cached_property
    def _explained(self) -> frozenset[str]:
        """The words of the comments in the package.xml: they may say why a dependency is left out."""
        parts = self._package.manifest.source.text.split("<!--")[1:]
        return frozenset(word for part in parts for word in _WORD.findall(part.partition("-->")[0]))

    @cached_property
    def _left_out(self) -> frozenset[str]:
        """The dependencies that are commented out without a word."""
        return frozenset(_BARE.findall(self._package.manifest.source.text))

    def lack(self, need: Need) -> Lack | None:
        """None when it is not known to be one, or the package.xml says why it is left out."""
        name = str(need.name)
        if not name or not self._is_known(need) or self._is_explained(need) or self._is_circular(need):
            return None
        if need.use == "interfaces":
            return None if "rosidl_core_runtime" in self._own else Lack.BROUGHT
        if name in _OF_LAUNCH:
            return Lack.BROUGHT if need.always and name not in self._of_own_launch else None
        if need.by_others:
            return Lack.BROUGHT if need.always and need.use != "plugin" else None
        if need.use == "plugin":
            return self._of_plugin(need)
        if need.use == "header":
            return Lack.PACKAGE if self._dependencies.is_of_workspace(need) else Lack.BROUGHT
        if self._is_declared(need, self._declared):
            return Lack.BROUGHT if need.always and not self._is_declared(need, self._own) else None
        if self._dependencies.stops_build(need):
            return Lack.BUILD
        if self._dependencies.is_lacking(need):
            return Lack.NOWHERE
        if need.always and self._is_named_itself(need):
            return self._of_always(need)
        if need.use not in _NAMED or not need.is_kept or self._may_come(need):
            return None
        if need.is_of_robot:
            return Lack.OPTIONAL if need.use in _STARTED and not is_simulation(name) else None
        if not need.by_default:
            return None
        return Lack.PACKAGE if need.use in _STARTED and self._is_of_robot(need) else Lack.ASIDE

    def is_unclear(self, need: Need) -> bool:
        """Whether a package is looked for of which nothing tells that there is one."""
        return need.use in _NAMED and self._dependencies.is_unheard_of(need)

    def _is_of_robot(self, need: Need) -> bool:
        """Whether a package of the workspace is for more than simulations: no rosdep brings it."""
        needed = self._launch.workspace.packages.get(str(need.name))
        return needed is not None and not is_simulation(needed.name) and self._dependencies.is_for_robot(needed)

    def _of_plugin(self, need: Need) -> Lack | None:
        """A plugin of others is missing where nothing of the tree brings it: they come with many packages."""
        if self._dependencies.is_of_workspace(need):
            return Lack.PACKAGE
        return Lack.NOWHERE if self._dependencies.is_lacking(need) and not self._may_come(need) else None

    def _of_always(self, need: Need) -> Lack | None:
        if need.fact is not None and not need.fact.declared:
            return None
        name = str(need.name)
        if self._dependencies.is_of_workspace(need):
            return Lack.PACKAGE
        if need.of_tests and name in base():
            return Lack.BROUGHT
        if not self._is_used(need) or self._dependencies.is_installed(need):
            return Lack.LIKELY
        if need.use == "module" and COMMON.get(name) in of_ros_base():
            return Lack.BROUGHT
        if self._may_come(need):
            return Lack.BROUGHT if name in self._brought and need.use in ("module", "library") else Lack.LIKELY
        return Lack.BASE if self._is_in_base(need) else Lack.PACKAGE

    def _is_known(self, need: Need) -> bool:
        """Whether a package is needed, or what rosdep has a key for, besides what launch and builds have anyway."""
        name = str(need.name)
        if need.use in ("header", "interfaces"):
            return need.use == "interfaces" or self._is_package(need)
        if _PLACEHOLDER.search(name) or package_like(self._launch, name):
            return False
        if need.use in _NAMED or need.use == "plugin":
            return True
        if name in _OF_LAUNCH:
            return need.use == "module"
        if name in _OF_TESTS:
            return need.of_tests and self._own.isdisjoint(_OF_TESTS[name])
        if name.startswith(_BUILD_TOOLS):
            return False
        if need.fact is not None:
            return True
        return need.use != "program" and (self._is_package(need) or name in COMMON)

    def _is_package(self, need: Need) -> bool:
        """Whether a module or a library is a package of ROS."""
        name = str(need.name)
        if name in base() or name.endswith(_MESSAGES) or self._dependencies.is_of_workspace(need):
            return True
        is_ros = name.startswith("rosidl_") or is_released(name) or is_known_package(name)
        return need.use in ("library", "header") and is_ros

    @staticmethod
    def _is_declared(need: Need, declared: frozenset[str]) -> bool:
        """Whether a dependency of another name is the same library, or brings it as far as its name tells."""
        key = COMMON.get(str(need.name), "") if need.use in ("module", "library") else ""
        if key:
            begin = _bare(key)
            return any(_bare(each).startswith(begin) for each in declared)
        if need.fact is None or need.fact.is_package:
            return False
        return any(map(need.fact.comes_with, declared))

    def _is_explained(self, need: Need) -> bool:
        """Whether a comment names it. One that only holds a dependency says nothing of what is started all the same,
        unless the tree fetches it."""
        name = str(need.name)
        is_left = name in self._left_out and need.use in _STARTED and not self._dependencies.is_fetched(name)
        return name in self._explained and not is_left

    def _is_circular(self, need: Need) -> bool:
        """Whether a package depends on the one that needs it, so that it cannot be declared: by its package.xml, or
        because it starts what only looks into its share folder."""
        needed = self._launch.workspace.packages.get(str(need.name))
        if needed is None:
            return False
        starts = need.use == "share" and any(
            each.use in _STARTED and each.name == self._package.name for each in self._dependencies.undeclared(needed)
        )
        return starts or self._package.name in self._launch.workspace.required(needed)

    def _is_used(self, need: Need) -> bool:
        """Whether CMake does more with a library than to look for it: a line that is left over needs no dependency."""
        if need.use != "library" or need.of_tests or need.name.startswith("rosidl_"):
            return True
        before, after = r"(?<!find_package\()(?<!find_package\( )(?<![\w-])", r"(?:(?![\w-])|_(?:DEF|INCL|LIB|TARG))"
        word = re.compile(f"{before}{re.escape(need.name)}{after}", re.I)
        return any(word.search(build.source.text) for build in self._package.builds)

    def _is_named_itself(self, need: Need) -> bool:
        """Whether a launch file for more than a trial names a package itself: the default of an argument is a choice.
        In a package for simulations, all launch files are for one."""
        if need.use not in _NAMED:
            return True
        is_trial = _TRIAL.search(need.name.span.source.basename) and self._dependencies.is_for_robot(self._package)
        return need.name.span.text.strip("'\"") == need.name and not is_trial

    def _is_in_base(self, need: Need) -> bool:
        name = str(need.name)
        return name in base() or (need.use in ("module", "library") and COMMON.get(name, "") in of_ros_base())

    def _may_come(self, need: Need) -> bool:
        """Whether something that is declared may bring a package, by the tables or by its name."""
        name = str(need.name)
        if name in self._brought:
            return True
        if need.fact is not None:
            is_known = need.use in _STARTED and is_released(name)
            return any(map(need.fact.comes_with, self._declared - lists() if is_known else self._declared))
        if name in base():
            return name in brought_by(self._declared & _METAPACKAGES)
        if need.use in _STARTED:
            return comes_with(self._launch, self._package, name)
        family = name.partition("_")[0]
        return name.endswith(_MESSAGES) and not self._declared.isdisjoint((family, f"{family}_msgs"))


def _bare(key: str) -> str:
    """A rosdep key without what differs between its spellings."""
    return _DECORATION.sub("", key).replace("_", "-")
