"""What decides whether the DDS of two robots hear each other, and how each is tuned.

Subject ``dds`` holds what two robots must have in common, whichever library each of them runs: the transport, the
port and the protocol of discovery, and the tag of the domain. What peers, variables or files that are not known may
change is not stated.

Tried with two participants each: those of Cyclone DDS 11.0.1 do not find each other with another tag, transport or base
of the ports, and do with other unicast ports; those of Fast DDS 2.14 do not with another base or gain of the ports,
transport, or a discovery server on one side.
"""

from __future__ import annotations

from bringup_lint.fleet.reduce.cyclonedds import cyclonedds
from bringup_lint.fleet.reduce.cyclonedds import tuning
from bringup_lint.fleet.reduce.fastdds import PROFILES
from bringup_lint.fleet.reduce.fastdds import fastdds
from bringup_lint.fleet.reduce.statements import Statements
from bringup_lint.graph.dds.selection import URI
from bringup_lint.graph.environment.ros import RosProcess
from bringup_lint.graph.purpose import Purpose
from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.source import Source
from bringup_lint.source import Span


def discovery(said: Statements) -> None:
    """What every process that runs ROS 2 on the robot says, by the middleware that it surely has."""
    for process in said.robot.ros.processes:
        rmw = process.environment.text("RMW_IMPLEMENTATION") or ""
        if said.robot.purpose(process.where) is not Purpose.ROBOT:
            continue
        if rmw == "rmw_cyclonedds_cpp":
            _cyclonedds(said, process)
        elif rmw in ("rmw_fastrtps_cpp", "rmw_fastrtps_dynamic_cpp"):
            _fastdds(said, process)


def _cyclonedds(said: Statements, process: RosProcess) -> None:
    domains = _domains(said, process)
    if domains is None:
        return
    for each in cyclonedds(domains, process.environment):
        said.state("dds", each.key, each.value, each.where or process.where)
    for each in tuning(domains, said.robot.dds.cyclonedds.version):
        said.state("dds-setting", each.key, each.value, each.where or process.where)


def _domains(said: Statements, process: RosProcess) -> list[Domain] | None:
    """The Domain blocks that count for a process, in no order; None where a part is not known or is refused."""
    if process.environment.defines(URI) is False:
        return []
    chosen = next((each for each in said.robot.dds.selections if each.process is process), None)
    if chosen is None or not chosen.complete:
        return None
    inline = [(each.span.source, each.span) for each in chosen.inline]
    found: list[Domain] = []
    for source, span in [*((file, None) for file in chosen.files), *inline]:
        read = next((each for each in said.robot.dds.configurations if _is_at(each, source, span)), None)
        if read is None or any(remark.fatal for remark in read.all_remarks):
            return None
        if any(not each.applies_to_any and chosen.domain is None for each in read.domains):
            return None
        found += (each for each in read.domains if each.applies_to_any or each.id == str(chosen.domain))
    return found


def _is_at(configuration: Configuration, source: Source, span: Span | None) -> bool:
    """Whether a configuration is a file, or the text at a place of one."""
    if configuration.source is not source or configuration.inline is not (span is not None):
        return False
    root = configuration.document.root
    return span is None or (root is not None and span.start <= root.span.start < span.end)


def _fastdds(said: Statements, process: RosProcess) -> None:
    participant = None
    if any(process.environment.defines(name) is not False for name in PROFILES):
        files = said.robot.dds.profiles_of(process)
        participants = [each for profiles in files for each in profiles.default_participants]
        if len(files) != 1 or files[0].dropped or len(participants) != 1:
            return
        participant = participants[0]
        transports = files[0].transports
    else:
        transports = []
    for each in fastdds(participant, transports, process.environment):
        said.state("dds", each.key, each.value, each.where or process.where)
