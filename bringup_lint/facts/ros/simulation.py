"""What names and texts tell of a simulation: the names of simulators, and words for what is simulated.

Isaac ROS runs on real robots; Isaac Sim, Isaac Lab and Isaac Gym simulate. SIM7600 and the like are modems.
"""

from __future__ import annotations

import re

from bringup_lint.pattern import regex

SIMULATORS = (
    r"gazebo\d*|gz|ign|ignition|webots|isaac_?(?:sim|lab|gym)\w*|omni\.isaac|mujoco|airsim|carla|awsim|stage_ros2?|unity"
    r"|pybullet|coppelia(?:sim)?"
)
WORDS = r"sim(?!_time)|sims|simulations?|simulators?|simulated"
HINTS = "sim gazebo gz ign webots isaac mujoco carla stage_ros unity pybullet coppelia"
"""Each simulator and each word holds one of these."""
TOLD = r"gazebo|\bgz[ _-]|ros_gz|webots|isaac|mujoco|coppelia|airsim|carla|stage_ros|pybullet|simulat"
"""Anywhere in a text, these hardly mean anything else. Isaac alone may mean Isaac Sim."""

BY_DEFAULT = {
    "slam_toolbox": ("online_async_launch.py", "online_sync_launch.py", "localization_launch.py"),
    "nav2_bringup": ("slam_launch.py",),
}
"""Public launch files whose use_sim_time is true by default and overrules what a parameter file says, from their
sources in every distribution from foxy on (localization_launch.py: from humble on)."""

_SIMULATOR = regex(rf"(?<![a-z0-9])(?:{SIMULATORS})(?![a-z0-9])", re.I, HINTS)
_NAMED = regex(rf"(?<![a-z0-9])(?:{SIMULATORS}|{WORDS})(?![a-z0-9])", re.I, HINTS)


def is_simulator(name: str) -> bool:
    """Whether a part of the name of a package, a program or a module of Python is that of a simulator."""
    return _SIMULATOR.search(name) is not None


def is_simulation(name: str) -> bool:
    """Whether a part of a name, also of a file, a unit or a service, or of a command line is that of a simulator, or a
    word for what is simulated."""
    return _NAMED.search(name) is not None
