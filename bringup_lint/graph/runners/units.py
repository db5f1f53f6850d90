"""Systemd services as runners."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.files import Files
from bringup_lint.graph.runners.layers import Layers
from bringup_lint.graph.runners.runner import Runner
from bringup_lint.graph.runners.runner import RunnerKind
from bringup_lint.graph.runners.runner import Stop
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units


def runners(files: Files, layers: Layers) -> Iterator[Runner]:
    units = layers.units()
    for unit in units.services:
        yield _of(files, units, unit)


def _of(files: Files, units: Units, unit: Unit) -> Runner:
    supervision = units.supervision(unit)
    signal = supervision.kill_signal
    return Runner(
        RunnerKind.UNIT,
        unit.name,
        unit.where,
        units.environment(unit),
        lines=list(units.processes(unit)),
        main=list(units.started(unit)),
        runs_ros=unit in units.dds,
        system=unit.place,
        user="root" if unit.identity.is_root else unit.identity.user,
        stop=Stop(signal.value, supervision.stop_timeout.value, signal.at),
        restarts=units.restart(unit).restarts,
        asks_status=_asks_status(units, unit),
        environment_files=tuple((each.value, each.source) for each in units.environment_files(unit) if each.source),
        purpose=files.purpose(unit.where, unit.name),
        unit=unit,
        reads=files.tree.find,
    )


def _asks_status(units: Units, unit: Unit) -> bool:
    """Whether a failure is told from another end: ``Restart=always`` makes no difference."""
    restart = units.restart(unit).restart
    return restart == "on-failure" or (restart == "no" and unit.get("OnFailure", "Unit") is not None)
