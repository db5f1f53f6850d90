"""The parameter layer: all parameter files of the tree, and who loads them."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.endings import CPP
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.memo import memo
from bringup_lint.graph.params import values as param_values
from bringup_lint.graph.params.values import Item
from bringup_lint.graph.words import words
from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile
from bringup_lint.model.params import Value
from bringup_lint.model.params import matches
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.parsers.params import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.declared import Declared
    from bringup_lint.graph.params.loads import Load
    from bringup_lint.graph.params.naming import Naming
    from bringup_lint.graph.workspace import Package

_UNTYPED = ("ardent", "bouncy", "crystal", "dashing", "eloquent", "foxy")
"""Distributions in which a declared parameter may take any type."""
_CODE = (".py", *CPP, ".rs")
_QUOTED = regex(r"[\"']([\w.]{3,80})[\"']")
_READS_YAML = regex(r"\byaml\.(?:safe_|full_|unsafe_)?load\b", hints="yaml")
_MOST_SOURCES = 4000


class Params:
    """The parameter files of a tree. ``launch`` is asked only where launch files may load one."""

    def __init__(self, files: Files, launch: Callable[[], Launch]) -> None:
        self.files = files
        self.launch = launch

    @property
    def distribution(self) -> str | None:
        """The distribution of ROS 2 that the tree is for."""
        return self.files.target.ros

    @cached_property
    def parameter_files(self) -> list[ParameterFile]:
        """The YAML files that hold ``ros__parameters``."""
        return self.files.parsed(parse, self.files.of_kind("params"))

    @cached_property
    def judged(self) -> list[ParameterFile]:
        """Those that findings may be about: really parameter files, neither context nor templates."""
        certain = (file for file in self.parameter_files if self.read_by(file) == "rcl" or self._may_load(file))
        return [file for file in (*certain, *self.plain) if file.source.judged and not file.source.template]

    def _may_load(self, file: ParameterFile) -> bool:
        """Whether rcl may read the file: it has the form, and is not an argument that the program reads by itself."""
        return file.is_certain and (bool(self.loads(file)) or file.source.absolute not in self._own)

    @cached_property
    def _own(self) -> frozenset[str]:
        """The files that launch files give to programs in options of their own (``--config``)."""
        if not self.files.of_kind(*LAUNCH):
            return frozenset()
        from bringup_lint.graph.params.loads import own_arguments

        launch = self.launch()
        return frozenset(path for expansion in launch.expansions for path in own_arguments(launch, expansion))

    @cached_property
    def plain(self) -> list[ParameterFile]:
        """Files without any ``ros__parameters`` that a node is given all the same."""
        sources = (self.files.tree.read(path, "params") for path in sorted(self._unclaimed))
        return self.files.parsed(parse, (source for source in sources if source is not None))

    @cached_property
    def _unclaimed(self) -> dict[str, list[Load]]:
        """Other YAML files of the tree that rcl gets from a launch file, with who gets them."""
        found: dict[str, list[Load]] = {}
        known = {source.absolute for source in self.files.sources}
        for load in self._all_loads:
            path = os.path.normpath(load.path)
            odd = load.how not in ("rcl", "substituted") or not path.endswith((".yaml", ".yml")) or path in known
            if not odd and load.certain and self.files.tree.walks(path):
                found.setdefault(path, []).append(load)
        return found

    def problems(self, *codes: str) -> Iterator[tuple[ParameterFile, Problem]]:
        """What makes rcl refuse a judged file."""
        for file in self.judged:
            for problem in file.problems:
                if problem.code in codes:
                    yield file, problem

    def refused(self, code: str) -> Iterator[tuple[ParameterFile, Parameter]]:
        """The parameters of judged files whose values rcl refuses for one reason."""
        for file, problem in self.problems(code):
            parameter = self.at(file, problem.where)
            if parameter is not None:
                yield file, parameter

    @cached_property
    def parameters(self) -> list[tuple[ParameterFile, Parameter]]:
        """Every value of the judged files, in the order of the text."""
        return [(file, parameter) for file in self.judged for parameter in file.parameters]

    def named(self, name: str) -> list[tuple[ParameterFile, Parameter]]:
        """Every value of a parameter in the judged files, in the order of the text."""
        return self._by_name.get(name, [])

    @cached_property
    def _by_name(self) -> dict[str, list[tuple[ParameterFile, Parameter]]]:
        found: dict[str, list[tuple[ParameterFile, Parameter]]] = {}
        for file, parameter in self.parameters:
            found.setdefault(str(parameter.name), []).append((file, parameter))
        return found

    def at(self, file: ParameterFile, where: Located | Span) -> Parameter | None:
        """The parameter whose value is at a place."""
        span = where.span if isinstance(where, Located) else where
        return next((each for each in file.parameters if each.span == span), None)

    def items(self, parameter: Parameter) -> list[Item]:
        """The scalars of a value; empty when a list holds anything else."""
        if isinstance(parameter.node, Scalar):
            return param_values.items(parameter)
        found = self._items.get(id(parameter))
        if found is None:
            found = self._items[id(parameter)] = param_values.items(parameter)
        return found

    @cached_property
    def _items(self) -> dict[int, list[Item]]:
        """The items of lists, by the parameter that has them."""
        return {}

    def is_switched_off(self, parameter: Parameter) -> bool:
        """Whether a section around a value says that it is not in use, as with ``enabled: false``, or is that of a
        plugin which no list of its node has."""
        if id(parameter.block) not in self._switched_off:
            self._switched_off[id(parameter.block)] = param_values.switched_off(parameter.block)
        words = parameter.name.split(".")
        sections = (".".join(words[:end]) for end in range(1, len(words)))
        return not self._switched_off[id(parameter.block)].isdisjoint(sections)

    @cached_property
    def _switched_off(self) -> dict[int, frozenset[str]]:
        return {}

    @property
    def duplicates(self) -> Iterator[tuple[ParameterFile, Parameter, Parameter]]:
        for file in self.judged:
            for first, second in param_values.duplicates(file):
                yield file, first, second

    def winner(self, file: ParameterFile, parameter: Parameter) -> Value | None:
        """What rcl's table holds in the end for the name of a parameter in its block."""
        return self._winners(file).get((parameter.block.name, parameter.name))

    @memo
    def _winners(self, file: ParameterFile) -> dict[tuple[str, str], Value | None]:
        """What the table holds that a file makes."""
        return param_values.winners(file)

    @property
    def is_typed(self) -> bool:
        """Whether a declared parameter takes one type only, in the distribution that the tree is for."""
        return self.distribution not in _UNTYPED

    @memo
    def declared(self, parameter: Parameter) -> Declared | None:
        """How the workspace declares a parameter: what all nodes that may get it agree on, None when that is not
        known."""
        file = self.of_source(parameter.span.source)
        if file is None or not self.is_typed:
            return None
        if not self.loads(file):
            return self._declared_in_own(file, parameter)
        found = None
        for load in _for_named(parameter, self.effective(file, parameter)):
            each = self.declared_by(text_of(load.node.package) if load.node.package is not None else None).get(
                parameter.name
            )
            if each is None or (found is not None and found.type != each.type):
                return None
            found = each
        return found

    def _declared_in_own(self, file: ParameterFile, parameter: Parameter) -> Declared | None:
        """How the package of a file declares a parameter for its program of the name of the block: a command line, as
        in a unit or compose file, gives the program the file. For a file outside of all packages, the only package
        with such a program."""
        program = parameter.block.name.strip("/")
        owner = self.launch().workspace.owner(file.source)
        if owner is None:
            owner = self._by_program.get(program)
        if owner is None or program not in owner.executables or not self.is_used(file):
            return None
        return self.declared_by(owner.name).get(parameter.name)

    @cached_property
    def _by_program(self) -> dict[str, Package | None]:
        """The only package with a program of each name; None where several have one."""
        found: dict[str, Package | None] = {}
        for package in self.launch().workspace.packages.values():
            for program in package.executables:
                found[program] = None if program in found else package
        return found

    @memo
    def declared_by(self, name: str | None) -> dict[str, Declared]:
        """The parameters of which the sources of a package of the workspace say the type, by name."""
        from bringup_lint.graph.params.declared import declared_in

        workspace = self.launch().workspace
        package = workspace.packages.get(name) if name else None
        return declared_in(workspace, package) if package else {}

    @cached_property
    def typed(self) -> list[tuple[Parameter, Declared]]:
        """The values whose type the workspace declares, with the declaration."""
        pairs = ((parameter, self.declared(parameter)) for _, parameter in self.parameters)
        return [(parameter, found) for parameter, found in pairs if found is not None]

    def is_unknown_to_code(self, file: ParameterFile, parameter: Parameter) -> bool:
        """Whether the sources of the tree name several other parameters of the same block, and not this one: what would
        read it is here, and does not."""
        if _last(parameter) in self._names_in_code:
            return False
        return len(self._names_by_block(file)[id(parameter.block)] & self._names_in_code) >= 3

    @memo
    def _names_by_block(self, file: ParameterFile) -> dict[int, set[str]]:
        found: dict[int, set[str]] = {}
        for each in file.parameters:
            found.setdefault(id(each.block), set()).add(_last(each))
        return found

    def is_named_in_code(self, name: str) -> bool:
        """Whether a source of the tree that has to do with parameters names one, or its last part."""
        return name in self._names_in_code or name.rpartition(".")[2] in self._names_in_code

    @cached_property
    def _names_in_code(self) -> frozenset[str]:
        """The texts in sources that have to do with parameters."""
        texts = (source.text for source in self.code)
        return frozenset(part for text in texts for name in _QUOTED.findall(text) for part in name.split("."))

    def is_read_by_program(self, file: ParameterFile) -> bool:
        """Whether a program of the tree that reads YAML itself names a file: it may do more with the values."""
        return file.source.basename in self._words_of_yaml_readers

    @cached_property
    def _words_of_yaml_readers(self) -> set[str]:
        return set().union(*(words(each.text) for each in self.code if each.matches(_READS_YAML)))

    @cached_property
    def code(self) -> list[Source]:
        """The sources of the tree that have to do with parameters."""
        paths = [path for path in self.files.tree.paths if path.endswith(_CODE)][:_MOST_SOURCES]
        sources = (self.files.tree.read(path, judged=False) for path in paths)
        return [source for source in sources if source is not None and "param" in source.text]

    def of_source(self, source: Source) -> ParameterFile | None:
        """The parameter file that a source is."""
        return self._by_source.get(id(source))

    @cached_property
    def _by_source(self) -> dict[int, ParameterFile]:
        return {id(file.source): file for file in self.parameter_files}

    @cached_property
    def _all_loads(self) -> list[Load]:
        if not self.files.of_kind(*LAUNCH):
            return []
        from bringup_lint.graph.params.loads import loads_in

        launch = self.launch()
        return [load for expansion in launch.expansions for load in loads_in(launch, expansion)]

    def is_used(self, file: ParameterFile) -> bool:
        """Whether a launch file loads a file, hands its path on, or takes any of its folder by argument, or something
        names it, and means no other one of its name."""
        return bool(self.loads(file)) or self._naming.is_named(file.source)

    def named_elsewhere(self, name: str, known: set[Source]) -> bool:
        """Whether a file other than the known ones and those that only build or install mentions a name."""
        return self._naming.is_elsewhere(name, known)

    @cached_property
    def _naming(self) -> Naming:
        from bringup_lint.graph.params.naming import Naming

        return Naming(self.files, self.launch)

    def at_path(self, path: str) -> ParameterFile | None:
        """The file at a path, of the tree or of the robot."""
        return self._paths.get(path) or self._paths.get(self.files.tree.real_path(path))

    @cached_property
    def _paths(self) -> dict[str, ParameterFile]:
        paths: dict[str, ParameterFile] = {}
        for file in self.parameter_files:
            path = file.source.absolute
            for name in (path, self.files.tree.real_path(path), file.source.robot_path):
                if name:
                    paths.setdefault(name, file)
        return paths

    @cached_property
    def _loads(self) -> dict[int, list[Load]]:
        paths = self._paths
        found: dict[int, list[Load]] = {}
        real: dict[str, str] = {}
        if paths:
            for load in self._all_loads:
                if load.path not in real:
                    real[load.path] = self.files.tree.real_path(load.path)
                file = paths.get(load.path) or paths.get(real[load.path])
                if file is not None:
                    found.setdefault(id(file), []).append(load)
        return found

    def loads(self, file: ParameterFile) -> list[Load]:
        """The nodes of the tree's launch files that are given a file."""
        found = self._loads.get(id(file))
        if found is None:
            found = self._unclaimed.get(file.source.absolute, [])
            self._loads[id(file)] = found
        return found

    def texts(self, node: Started, name: str) -> list[Located] | None:
        """The list of texts that parameter files give a launched node, each text with its place; None when that is
        not known."""
        found = None
        for load in self._by_node.get(id(node), ()):
            file = self.at_path(load.path)
            if file is None or not file.accepted or load.root_key is not None or not load.certain:
                return None
            for parameter in file.parameters:
                if parameter.name == name and load in self.effective(file, parameter):
                    items = self.items(parameter)
                    found = [Located(item.text, item.span) for item in items if item.type == "string"]
        return found or None

    @cached_property
    def _by_node(self) -> dict[int, list[Load]]:
        found: dict[int, list[Load]] = {}
        for load in self._all_loads:
            found.setdefault(id(load.node), []).append(load)
        return found

    def is_included(self, load: Load) -> bool:
        """Whether the load is that of a file launched alone which another file of the tree includes."""
        return id(load.expansion.entry) in self.launch().included

    def effective(self, file: ParameterFile, parameter: Parameter) -> list[Load]:
        """The loads by which a value may reach a node: its block may be for the node, and nothing later sets it
        again."""
        found = self._reached(file, parameter)
        return [load for load, names in found if names is not None and parameter.name not in names]

    def is_replaced(self, file: ParameterFile, parameter: Parameter) -> bool:
        """Whether each node that gets a value from a file may get another one later."""
        return bool(self._reached(file, parameter)) and not self.effective(file, parameter)

    def _reached(self, file: ParameterFile, parameter: Parameter) -> list[tuple[Load, frozenset[str] | None]]:
        """The loads for whose nodes the block of a parameter may be, each with the names that are set again later."""
        block = parameter.block.name
        known = self._reached_by_block.get((id(file), block))
        if known is None:
            from bringup_lint.graph.params.loads import replaced

            named = [(load, load.node.fqn) for load in self.loads(file)]
            known = [(load, replaced(load)) for load, fqn in named if fqn is None or matches(block, fqn)]
            self._reached_by_block[id(file), block] = known
        return known

    @cached_property
    def _reached_by_block(self) -> dict[tuple[int, str], list[tuple[Load, frozenset[str] | None]]]:
        return {}

    @memo
    def read_by(self, file: ParameterFile) -> str:
        """``rcl`` when at least one node gets the file as it is, ``pyyaml`` when all get it through PyYAML, or none
        gets it and a launch file that names it reads YAML, else empty."""
        ways = {load.how for load in self.loads(file)}
        if ways & {"rcl", "substituted"}:
            return "rcl"
        name = file.source.basename
        readers = () if ways else self.files.of_kind("launch-python")
        return "pyyaml" if ways or any(each.matches(_READS_YAML) and name in each.text for each in readers) else ""


def _last(parameter: Parameter) -> str:
    return str(parameter.name).rpartition(".")[2]


def _for_named(parameter: Parameter, loads: list[Load]) -> list[Load]:
    """Without the nodes of unknown names beside one that the block names: two of one name do not start together."""
    if "*" in parameter.block.name:
        return loads
    named = [load for load in loads if load.node.fqn is not None]
    if len(named) == len(loads):
        return loads
    beside = {id(load.expansion) for load in named}
    return [load for load in loads if load.node.fqn is not None or id(load.expansion) not in beside]
