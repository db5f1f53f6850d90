"""What the launch files, descriptions and Python modules of a package ask of other packages."""

from __future__ import annotations

import os
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.needed import Needed
from bringup_lint.facts.ros.needed import needed
from bringup_lint.facts.ros.simulation import is_simulation
from bringup_lint.graph.dependencies.imports import imported
from bringup_lint.graph.dependencies.shares import shares_of_description
from bringup_lint.graph.dependencies.shares import shares_of_python
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.modules import modules
from bringup_lint.graph.purpose import Purpose
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Node
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package


_CONTROLLERS = "ros2_controllers"


class Need(NamedTuple):
    use: str
    """``node``, ``include``, ``share`` and ``program`` in a launch file, ``description`` for what xacro looks up,
    ``module`` that Python imports, ``library`` that CMake finds, ``interfaces`` that are generated, ``plugin`` that a
    controller manager loads, ``header`` that C++ includes."""
    name: Located
    owner: Package
    """The package whose file asks for it."""
    always: bool = True
    """On the robot, without an argument, and with no way round it."""
    is_component: bool = False
    """A container loads it, and launch goes on without it."""
    is_of_robot: bool = True
    """An installed file of the robot asks for it, perhaps by an argument alone."""
    is_kept: bool = True
    """An installed file asks for it, be it for a simulator or an example."""
    by_default: bool = True
    """No argument is needed for it."""
    by_others: bool = False
    """Another package of the workspace declares it, on which this one depends."""
    is_process: bool = False
    """A command of a launch file runs it, and launch goes on without it."""
    of_tests: bool = False
    """Only tests need it, which colcon builds where nobody says ``-DBUILD_TESTING=OFF``."""

    @property
    def fact(self) -> Needed | None:
        """What is known of it; None of what ros-base has, and of what no table knows."""
        name = str(self.name)
        own = needed(self.use, name) if self.use in ("module", "library") else None
        found = own or needed("package", name)
        return Needed(True, name, "", (_CONTROLLERS,)) if found is None and self.use == "plugin" else found


def of_launch(files: Files, launch: Launch) -> Iterator[Need]:
    """The packages whose nodes and launch files are started."""
    for node in launch.nodes:
        name, owner = literal_text(node.package), launch.workspace.owner(node.file.source)
        if name is not None and owner is not None:
            is_of_robot, is_kept = _is_of_robot(files, launch, node.file, owner), _is_kept(node.file, owner)
            is_loaded, by_default = isinstance(node.action, ComposableNode), node.by_default is True
            always, is_process = is_of_robot and by_default, not isinstance(node.action, (Node, ComposableNode))
            need = Need("node", name, owner, always, is_loaded, is_of_robot, is_kept, by_default)
            yield need._replace(is_process=is_process)
    for file in launch.judged:
        owner = launch.workspace.owner(file.source)
        if owner is None:
            continue
        for include in launch.expansion(file).includes:
            chosen = include.conditions or any(isinstance(each, Choice) for each in walk(include.file))
            is_of_robot, is_kept = _is_of_robot(files, launch, file, owner), _is_kept(file, owner)
            if include.source is file:
                for name in _shares(include.file):
                    always, by_default = is_of_robot and not chosen, not chosen
                    yield Need("include", name, owner, always, False, is_of_robot, is_kept, by_default)


def of_launch_files(files: Files, launch: Launch) -> Iterator[Need]:
    """What ends a launch file when it is missing: the modules that it imports, and xacro."""
    folders = _python_packages(files)
    for file in launch.judged:
        owner = launch.workspace.owner(file.source)
        if owner is None:
            continue
        always, is_kept = _is_of_robot(files, launch, file, owner), _is_kept(file, owner)
        if file.source.kind == "launch-python":
            for name in shares_of_python(file.source):
                yield Need("share", name, owner, always, is_of_robot=always, is_kept=is_kept)
            yield from (Need("module", module, owner, always) for module in _foreign(launch, folders, file.source))
    for node in launch.nodes:
        owner = launch.workspace.owner(node.file.source)
        if owner is not None and isinstance(node.action, Node):
            always = node.by_default is True and _is_of_robot(files, launch, node.file, owner)
            for program in _programs(node.action.parameters):
                yield Need("program", program, owner, always)


def _programs(values: Iterable[Value]) -> Iterator[Located]:
    """The programs whose output is a parameter."""
    for value in values:
        for command in walk(value):
            if isinstance(command, Command):
                first = next((each for each in walk(command.command) if isinstance(each, Literal)), None)
                words = first.value.split() if first is not None and isinstance(first.value, str) else []
                if first is not None and words:
                    yield Located(words[0], first.span)


def _is_of_robot(files: Files, launch: Launch, file: LaunchFile, owner: Package) -> bool:
    """Installed, and neither for tests nor for a simulation, where the package is not for one itself."""
    if not _is_kept(file, owner) or not is_meant(files, file.source, owner):
        return False
    return files.purpose(owner.manifest.source) is Purpose.SIMULATION or not _simulates(launch, file)


def _is_kept(file: LaunchFile, owner: Package) -> bool:
    """Whether a launch file of ROS 2 may be installed."""
    return not file.ros1 and (not owner.installs_known or is_installed(owner, file.source))


def _simulates(launch: Launch, file: LaunchFile) -> bool:
    """Whether a launch file starts a simulator when no argument is passed."""
    expansion = launch.expansion(file)
    packages = {str(literal_text(node.package)) for node in expansion.nodes if node.by_default is True}
    included = (launch.place(include.file) for include in expansion.includes if not include.conditions)
    packages |= {each.package for each in included if each is not None}
    return any(map(is_simulation, packages))


def is_meant(files: Files, source: Source, owner: Package) -> bool:
    """Whether a file is for the robot, or for the same as its package: all files of a package of examples are ones."""
    purpose = files.purpose(source)
    return purpose is Purpose.ROBOT or purpose is files.purpose(owner.manifest.source)


def _shares(value: Value) -> Iterator[Located]:
    for each in walk(value):
        if isinstance(each, PackageShare) and isinstance(each.package, Literal) and isinstance(each.package.value, str):
            yield Located(each.package.value, each.package.span)


def is_installed(owner: Package, source: Source) -> bool:
    """Whether a package installs a file, as such or in its Python package."""
    return owner.takes(source.absolute) or _is_of_module(owner, source)


def _is_of_module(owner: Package, source: Source) -> bool:
    """Whether a file lies in the Python package that CMake installs for a package, be it in ``src``."""
    if not any(build.installs_python for build in owner.builds):
        return False
    folders = os.path.relpath(source.absolute, owner.folder).split(os.sep)[:-1]
    return owner.name in folders[:2]


def of_nodes(files: Files, launch: Launch) -> Iterator[Need]:
    """The modules that the nodes of packages import whenever they start, and that are not in the tree."""
    folders = _python_packages(files)
    for source in [*files.of_kind("python-node"), *modules(files)]:
        owner = launch.workspace.owner(source)
        if owner is None or not source.judged:
            continue
        is_run = source.kind == "python-node" or source.basename in owner.executables
        is_module = _is_of_module(owner, source) or _is_of_setup(files, owner, source)
        if not is_module and not (is_run and owner.takes(source.absolute)):
            continue
        is_example = files.purpose(source) is Purpose.EXAMPLE and owner.takes(source.absolute)
        if not is_example and not is_meant(files, source, owner):
            continue
        yield from (Need("module", module, owner) for module in _foreign(launch, folders, source))


def _is_of_setup(files: Files, owner: Package, source: Source) -> bool:
    """Whether setuptools installs a file, not one that lies beside the Python packages."""
    beside = os.path.join(os.path.dirname(source.absolute), "__init__.py")
    return owner.manifest.build_type == "ament_python" and files.tree.exists(beside)


def _foreign(launch: Launch, folders: dict[str, list[str]], source: Source) -> Iterator[Located]:
    """The modules that a file imports and that are not in the tree, which has Python packages in these folders, and
    those of other packages of the workspace."""
    for module in imported(source):
        name = module.partition(".")[0]
        if name in folders:
            is_foreign = _is_of_another(launch, folders[name], source, name)
        else:
            is_foreign = not any(launch.workspace.tree.named(f"{name}.py"))
        if is_foreign:
            yield Located(name, module.span)


def _is_of_another(launch: Launch, folders: list[str], source: Source, name: str) -> bool:
    """Whether each folder of a name lies in the package of this name, and the file in another one."""
    package, owner = launch.workspace.packages.get(name), launch.workspace.owner(source)
    return package is not None and package is not owner and all(_lies_in(each, package.folder) for each in folders)


def _lies_in(path: str, folder: str) -> bool:
    return path.startswith(f"{folder}/")


def _python_packages(files: Files) -> dict[str, list[str]]:
    """The absolute paths of folders with modules, by their names."""
    found: dict[str, list[str]] = {}
    for path in files.tree.named("__init__.py"):
        folder = os.path.dirname(os.path.abspath(path))
        found.setdefault(os.path.basename(folder), []).append(folder)
    return found


def of_descriptions(files: Files, launch: Launch) -> Iterator[Need]:
    """The packages in which xacro looks for what descriptions of the robot include or name."""
    for source in files.of_kind("urdf"):
        owner = launch.workspace.owner(source)
        if owner is None or not source.judged or is_simulation(source.basename):
            continue
        if is_meant(files, source, owner):
            always = is_installed(owner, source)
            yield from (Need("description", name, owner, always) for name in shares_of_description(source))
