"""The layers of a robot's stack, told by the names of its units: what drives hardware, what perceives, what
decides."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable

from bringup_lint.graph.systemd.unit import Unit

HARDWARE = "hardware"
PERCEPTION = "perception"
APPLICATION = "application"
SAFETY = "safety"
RANK = {HARDWARE: 0, SAFETY: 0, PERCEPTION: 1, APPLICATION: 2}

_WORDS = {
    HARDWARE: "driver drivers hw hardware base chassis sensor sensors lidar laser camera cameras imu motor "
    "motors canbus gps gnss sonar microros actuators servo servos",
    PERCEPTION: "perception slam localization localisation mapping fusion detection tracking odometry ekf",
    APPLICATION: "navigation nav2 navigator planner planning application applications app mission missions "
    "behavior behaviour autonomy",
    SAFETY: "safety estop emergency watchdog",
}
_LAYER = {word: layer for layer, words in _WORDS.items() for word in words.split()}


def layers(units: Iterable[Unit]) -> dict[str, str]:
    """Unit name -> layer, for those whose names tell one clearly; a first word that all share says
    nothing."""
    units = list(units)
    words = {unit.name: re.split(r"[-_.@\d]+", unit.stem.lower()) for unit in units}
    firsts = Counter(own[0] for own in words.values())
    found = {}
    for name, own in words.items():
        rest = own[1:] if len(own) > 1 and firsts[own[0]] > 1 else own
        told = {_LAYER[word] for word in rest if word in _LAYER}
        if len(told) == 1:
            found[name] = told.pop()
    return found
