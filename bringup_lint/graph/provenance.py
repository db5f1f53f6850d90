"""The chain of lines by which something comes into effect: unit, script, launch files, node, parameter file, value.

Every step is a line of the tree that names the next one. Where no line leads to a place, the chain is empty.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.finding import Related
from bringup_lint.finding import span_of
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.commands.command_line import CommandLine
    from bringup_lint.graph.commands.command_line import Step
    from bringup_lint.graph.dds.dds import Dds
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.loads import Load
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.runners.launching import Launching
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.model.launch import Action
    from bringup_lint.model.launch import LaunchFile

Steps = tuple[Related, ...]


@dataclass(frozen=True, eq=False)
class Provenance:
    """The chains of one robot; each is empty when nothing in the tree leads there."""

    runners: Runners
    launch: Launch
    params: Callable[[], Params]
    dds: Callable[[], Dds]

    def chain_to(self, where: Located | Span | Source, last: str) -> Steps:
        """The chain to a place, which is the last step and does what ``last`` says."""
        span = span_of(where)
        find = self._finders.get(span.source.kind)
        steps = find(span) if find else ()
        return (*steps, Related(span, last)) if steps else ()

    def chain_to_node(self, node: Started, *more: Related) -> Steps:
        """The chain to a node that a launch file starts."""
        steps = self._to_node(node)
        return (*steps, *more) if len(steps) > 1 or (steps and more) else ()

    def chain_to_load(self, load: Load, *more: Related) -> Steps:
        """The chain to a node and the parameter file that it gets."""
        name = load.path.rpartition("/")[2]
        return (*self._to_node(load.node), Related(load.where, f"{load.node.label()} gets {name}"), *more)

    def chain_to_variable(self, process: RosProcess, value: Located, *more: Related) -> Steps:
        """The chain to the place that gives a process the value of a variable, and on from there."""
        steps = (*self._to_variable(process, value), *more)
        return steps if len(steps) > 1 else ()

    @cached_property
    def _finders(self) -> dict[str, Callable[[Span], Steps]]:
        launch = dict.fromkeys(LAUNCH, self._in_launch_file)
        dds = dict.fromkeys(("cyclonedds", "fastdds"), self._in_dds_file)
        files = dict.fromkeys(("env-file", "shell-script"), self._in_read_file)
        return {**launch, **dds, **files, "params": self._in_parameters}

    @cached_property
    def _starts(self) -> list[tuple[Steps, Expansion]]:
        """Every command that starts a launch file, as steps, with what it leads to."""
        return [
            (self._to_command(command), self.launch.expansion(command.file))
            for command in self.runners.launches
            if command.file is not None
        ]

    @cached_property
    def _nodes(self) -> dict[Action, tuple[Steps, Started]]:
        """The chain to the launch file of every node, by its action, and the node as it is started there."""
        found: dict[Action, tuple[Steps, Started]] = {}
        for steps, expansion in self._all_expansions:
            for node in expansion.nodes:
                found.setdefault(node.action, ((*steps, *_includes(node.chain, node.file)), node))
        return found

    @property
    def _all_expansions(self) -> Iterator[tuple[Steps, Expansion]]:
        yield from self._starts
        for expansion in self.launch.entries:
            yield (), expansion

    def _to_node(self, node: Started) -> Steps:
        steps, _ = self._nodes.get(node.action, ((), node))
        return (*steps, Related(node.span, f"{node.file.source.basename} starts {node.label()}"))

    def _to_command(self, command: Launching) -> Steps:
        file = command.target.rpartition("/")[2]
        script = command.start.step.script
        if script is None:
            return (Related(command.target.span, f"{command.runner.name} launches {file}"),)
        launches = Related(command.target.span, f"{script.basename} launches {file}")
        return (*self._to_script(command.runner, command.start.line, script), launches)

    def _to_script(self, runner: Runner, line: CommandLine, script: Source) -> Steps:
        """From the command line of a runner through the scripts that call each other."""
        steps: list[Related] = []
        seen: set[Source] = set()
        wanted: Source | None = script
        while wanted is not None and wanted not in seen:
            seen.add(wanted)
            caller = next((step for step in line.steps if step.script is not wanted and _calls(step, wanted)), None)
            if caller is None:
                break
            word = next(word for word in caller.command.words if word.endswith(f"/{wanted.basename}"))
            who = caller.script.basename if caller.script else runner.name
            steps.insert(0, Related(word.span, f"{who} runs {wanted.basename}"))
            wanted = caller.script
        return tuple(steps)

    def _to_variable(self, process: RosProcess, value: Located) -> Steps:
        return self._from_runner(process.runner, value.span.source) if process.runner is not None else ()

    def _from_runner(self, runner: Runner, source: Source) -> Steps:
        """From a runner to an environment file that it reads, or a script that it runs."""
        for word, file in runner.environment_files:
            if file is source:
                return (Related(word.span, f"{runner.name} reads {source.basename}"),)
        for line in runner.lines:
            if any(step.script is source for step in line.steps):
                return self._to_script(runner, line, source)
        return ()

    def _in_launch_file(self, span: Span) -> Steps:
        inside = [found for found in self._nodes.values() if found[1].span.holds(span)]
        if inside:
            steps, node = min(inside, key=lambda found: found[1].span.end - found[1].span.start)
            return self._to_node(node) if steps else ()
        for steps, expansion in self._all_expansions:
            if any(file.source is span.source for file in expansion.files):
                return (*steps, *self._to_file(expansion, span.source))
        return ()

    @staticmethod
    def _to_file(expansion: Expansion, source: Source) -> Steps:
        for include in expansion.includes:
            if include.target is not None and include.target.source is source:
                return _includes(include.chain, include.target)
        return ()

    def _in_parameters(self, span: Span) -> Steps:
        params = self.params()
        file = next((file for file in params.judged if file.source is span.source), None)
        if file is None:
            return ()
        parameter = next((each for each in file.parameters if each.span.holds(span)), None)
        loads = params.effective(file, parameter) if parameter else params.loads(file)
        load = next((load for load in loads if load.node.action in self._nodes), None)
        return self.chain_to_load(load) if load else ()

    def _in_dds_file(self, span: Span) -> Steps:
        dds = self.dds()
        readers = [(each.process, each.uri) for each in dds.selections if span.source in each.files]
        profiles = [each for each in dds.profile_files if each.source is span.source]
        readers += [reader for each in profiles for reader in dds.profile_readers(each)]
        for process, value in readers:
            named = Related(value.span, f"{value.span.source.basename} names {span.source.basename}")
            return (*self._to_variable(process, value), named)
        return ()

    def _in_read_file(self, span: Span) -> Steps:
        found = (self._from_runner(runner, span.source) for runner in self.runners.all)
        return next(filter(None, found), ())


def _includes(chain: tuple[Span, ...], file: LaunchFile) -> Steps:
    """The includes of a chain, each with the file that it leads to."""
    names = (*(span.source.basename for span in chain[1:]), file.source.basename)
    pairs = zip(chain, names, strict=False)
    return tuple(Related(span, f"{span.source.basename} includes {name}") for span, name in pairs)


def _calls(step: Step, script: Source) -> bool:
    return any(word.endswith(f"/{script.basename}") for word in step.command.words)
