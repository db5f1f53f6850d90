"""Topics with only one side."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.pattern import regex

EVERYWHERE = (
    "/rosout",
    "/parameter_events",
    "/clock",
    "/tf",
    "/tf_static",
    "/diagnostics",
    "/diagnostics_agg",
    "/bond",
)
"""Topics that tools, or every node, use."""
_MADE_UNSEEN = regex(r"/transition_event$|/_action/(?:feedback|status)$")
"""What lifecycle nodes and action servers publish by themselves."""
BY_HAND = regex(
    r"goal|initial_?pose|clicked|command|cmd|joy|teleop|stop|start|trigger|request|enable|reset|mode|feedback|set_|debug|input"
)
"""Topics to which a person, a tool or another computer publishes."""
FIRMWARE = regex(r"^/(?:utlidar|lf|rt|fmu/out)/|^/(?:low|sportmode|wirelesscontroller|handstate)\w*$")
"""Topics that controllers of robots publish by themselves: Unitree's motion computer, PX4."""
FIRMWARE_TYPES = ("unitree_go/", "unitree_hg/", "unitree_api/", "px4_msgs/")


def unmatched_endpoints(running: Running) -> Iterator[Use]:
    """The uses of topics that no other side of the running nodes uses, whether or not it starts by default."""
    for topic, uses in running.by_topic().items():
        if len({use.role for use in uses}) == 1 and topic not in EVERYWHERE and not _MADE_UNSEEN.search(topic):
            yield from (use for use in uses if not use.implied and use.node.started.by_default is True)


def without_publisher(running: Running) -> Iterator[Use]:
    """The subscriptions of sources in the tree that nobody serves, and that nobody serves by hand."""
    for use in unmatched_endpoints(running):
        if use.role != "subscription" or use.of_table or use.conditional or _is_of_firmware(use):
            continue
        if not BY_HAND.search(use.topic):
            yield use


def _is_of_firmware(use: Use) -> bool:
    return bool(FIRMWARE.search(use.topic)) or (use.type or "").startswith(FIRMWARE_TYPES)
