"""Values of Navigation2 that its servers refuse or replace, and values of one node that contradict each other."""

from __future__ import annotations

import os
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.facts import table
from bringup_lint.facts.ros import distros
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.questions.navigation_blocks import NavigationProblem
from bringup_lint.graph.params.questions.navigation_blocks import by_name
from bringup_lint.graph.params.questions.navigation_blocks import number_of
from bringup_lint.graph.params.questions.navigation_blocks import numbers_of
from bringup_lint.graph.params.questions.navigation_critics import blind_controllers
from bringup_lint.graph.params.questions.navigation_critics import critics_of
from bringup_lint.graph.params.questions.navigation_critics import plain
from bringup_lint.graph.params.questions.navigation_options import lost_reversals
from bringup_lint.graph.params.questions.navigation_shapes import hidden_zones
from bringup_lint.graph.params.questions.navigation_shapes import inscribed_radius
from bringup_lint.graph.params.questions.navigation_shapes import points_of
from bringup_lint.graph.params.questions.navigation_shapes import shape_of
from bringup_lint.graph.params.questions.navigation_shapes import two_radii
from bringup_lint.graph.params.questions.navigation_siblings import other_scan
from bringup_lint.graph.params.questions.navigation_siblings import two_inputs
from bringup_lint.graph.params.questions.navigation_speeds import short_steps
from bringup_lint.graph.params.questions.navigation_speeds import slower_smoother
from bringup_lint.graph.params.values import items
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from collections.abc import Callable

    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_OBSTACLE, _RAYTRACE = 2.5, 3.0
"""Default ranges of an observation source in metres (nav2_costmap_2d, obstacle_layer.cpp)."""
_OBSTACLE_LAYERS = ("nav2_costmap_2d::ObstacleLayer", "nav2_costmap_2d::VoxelLayer")
_SIGNS = (("max_velocity", 1), ("min_velocity", -1), ("max_accel", 1), ("max_decel", -1))
"""Limits of the velocity smoother, and the sign that each number of them must have or be zero."""
_LIMITS = (*(name for name, _ in _SIGNS), "deadband_velocity")
_PLANAR, _SPATIAL = 3, 6
"""Numbers of a limit: x, y and theta, or all six axes in newer releases (velocity_smoother.cpp)."""
_COORDINATES = tuple(f"initial_pose.{each}" for each in ("x", "y", "z", "yaw"))
_OLD_MODELS = {
    "differential": "nav2_amcl::DifferentialMotionModel",
    "omnidirectional": "nav2_amcl::OmniMotionModel",
}
"""What amcl called its motion models before Humble made plugins of them."""
_BEFORE_PLUGINS = ("crystal", "dashing", "eloquent", "foxy", "galactic")
_SINCE_HUMBLE = frozenset(("velocity_smoother", "behavior_server", "collision_monitor"))
"""Nodes that no distribution before Humble has."""


_SEEN = ("LaserScan", "PointCloud2", "")
"""What an obstacle layer takes as the type of a source (obstacle_layer.cpp)."""
_OLD_TREE = "default_bt_xml_filename"
"""The parameter that bt_navigator declared before Galactic."""
_TREES = {
    "default_nav_through_poses_bt_xml": ("navigate_to_pose", "'goal', and NavigateThroughPoses sets 'goals'"),
    "default_nav_to_pose_bt_xml": ("navigate_through_poses", "'goals', and NavigateToPose sets 'goal'"),
}
"""The name that trees of the other action have (nav2_bt_navigator, behavior_trees), and what the navigator sets
(navigate_through_poses.cpp, navigate_to_pose.cpp)."""
_RECOVERIES, _BEHAVIORS = "recoveries_server", "behavior_server"
"""One server, before Humble and since."""
_OF_BEHAVIORS = {
    "global_frame": "odom",
    "robot_base_frame": "base_link",
    "cycle_frequency": 10.0,
    "simulate_ahead_time": 2.0,
    "max_rotational_vel": 1.0,
    "min_rotational_vel": 0.4,
    "rotational_acc_lim": 3.2,
}
"""What both declare, with the defaults (behavior_server.cpp, spin.cpp)."""


def navigation_problems(params: Params) -> Iterator[NavigationProblem]:
    for file in params.judged:
        if _is_read(file) and params.is_used(file):
            for block in file.blocks:
                check = _CHECKS.get(block.node_name)
                if check is not None:
                    found = check(params, file, block)
                    yield from (each for each in found if not _is_replaced(params, file, block, each))


def _is_read(file: ParameterFile) -> bool:
    """Whether Navigation2 takes a file, at least once its launch files have filled in the namespace of the robot."""
    return not file.uncertain and all(each.code == "node-key" and "<" in str(each.where) for each in file.problems)


def _is_replaced(params: Params, file: ParameterFile, block: Block, problem: NavigationProblem) -> bool:
    """Whether every node that gets the file gets another value for one of the two sides."""
    places = [problem.where, *([problem.other] if problem.other is not None else [])]
    named = (each for each in block.parameters if any(each.span.holds(place) for place in places))
    return any(params.is_replaced(file, each) for each in named)


def _costmap(params: Params, file: ParameterFile, block: Block) -> Iterator[NavigationProblem]:
    named = by_name(block)
    shape = shape_of(named)
    if shape is not None and shape.name == "footprint":
        yield from _footprint(shape)
    yield from _inflation(file, named)
    yield from _jumping(params, file, block, named)
    if block.node_name == "local_costmap":
        yield from two_radii(file, block)
        yield from two_inputs(params, file, block)
    for layer in _layers(named):
        yield from _observations(params, named, layer)
        yield from _never_cleared(named, layer)


def _jumping(
    params: Params, file: ParameterFile, block: Block, named: dict[str, Parameter]
) -> Iterator[NavigationProblem]:
    """A window that moves with the robot in a frame that jumps against it whenever amcl corrects the pose."""
    rolling, frame = named.get("rolling_window"), named.get("global_frame")
    if frame is None or rolling is None or rolling.value.data is not True or block.node_name != "local_costmap":
        return
    localized = [by_name(each) for each in file.blocks if each.node_name == "amcl"]
    frames = [(_text(named, "global_frame_id", "map"), _text(named, "odom_frame_id", "odom")) for named in localized]
    if frames and frame.value.data == frames[0][0] != frames[0][1] and not _is_static(params, *frames[0]):
        yield NavigationProblem("frame", frame.span, "global_frame", str(frame.value.data), rolling.span)


def _is_static(params: Params, parent: str, child: str) -> bool:
    """Whether a launch file starts a static_transform_publisher for two frames."""
    for node in params.launch().nodes:
        if literal_text(node.executable) == "static_transform_publisher":
            words = " ".join(text_of(each) or "" for each in node.arguments).split()
            if parent in words and child in words:
                return True
    return False


def _text(named: dict[str, Parameter], name: str, default: str) -> str:
    return str(named[name].value.data) if name in named else default


def _navigator(params: Params, file: ParameterFile, block: Block) -> Iterator[NavigationProblem]:
    """Libraries that bt_navigator loads itself, the first with the number of the others, and trees of the other
    action."""
    named = by_name(block)
    for name, (wrong, right) in _TREES.items():
        each = named.get(name)
        if each is not None and isinstance(each.value.data, str) and wrong in each.value.data.rpartition("/")[2]:
            yield NavigationProblem("tree", each.span, name, right)
    old = named.get(_OLD_TREE)
    if old is not None and old.value.data and _is_since_humble(params, file):
        yield NavigationProblem("old-tree", old.key.span, _OLD_TREE, old.text)
    libraries = named.get("plugin_lib_names")
    loaded = _loaded(params.distribution) if libraries is not None else frozenset()
    twice = [item for item in items(libraries) if item.text in loaded] if libraries is not None else []
    if twice:
        more = f" ({len(twice)} of the list)" if len(twice) > 1 else ""
        yield NavigationProblem("library", twice[0].span, twice[0].text, more)


def _loaded(distribution: str | None) -> frozenset[str]:
    """What the bt_navigator of a distribution loads itself."""
    rows = (row for row in table("ros/bt_nodes") if distribution in row["distributions"].split())
    return frozenset(row["library"] for row in rows)


def _footprint(parameter: Parameter) -> Iterator[NavigationProblem]:
    text = parameter.value.data
    if not isinstance(text, str) or "$" in text:
        return
    points = points_of(text)
    if points is None:
        reason = "it is not a list of at least three points of two numbers"
        yield NavigationProblem("footprint", parameter.span, "footprint", reason)
    elif any(first == second for first, second in pairwise([*points, points[0]])) and points[0] != points[-1]:
        yield NavigationProblem("corner", parameter.span, "footprint", f"{len(set(points))} of {len(points)} corners")


def _inflation(file: ParameterFile, named: dict[str, Parameter]) -> Iterator[NavigationProblem]:
    """Inflation below the inscribed radius, about which the layer itself warns. The robot keeps clear of obstacles all
    the same where another costmap of the file has a smaller radius for it."""
    shape = shape_of(named)
    inscribed = inscribed_radius(shape) if shape is not None else None
    smallest = min(_inscribed(file), default=inscribed)
    for name, each in named.items():
        radius = number_of(each)
        if not name.endswith(".inflation_radius") or radius is None or inscribed is None or shape is None:
            continue
        layer = name.rpartition(".")[0]
        if layer in _active(named) and 0 < radius < inscribed:
            kind = "inflation" if smallest is None or radius < smallest else "inflation-logged"
            yield NavigationProblem(kind, each.span, name, f"{inscribed:.2f}", shape.span)


def _inscribed(file: ParameterFile) -> Iterator[float]:
    """The inscribed radii of the robot in the costmaps of a file."""
    for block in file.blocks:
        shape = shape_of(by_name(block)) if block.node_name.endswith("_costmap") else None
        radius = inscribed_radius(shape) if shape is not None else None
        if radius is not None:
            yield radius


def _layers(named: dict[str, Parameter]) -> Iterator[str]:
    """The active layers that mark what their observation sources see."""
    for layer in _active(named):
        plugin = named.get(f"{layer}.plugin")
        if plugin is not None and plugin.value.data in _OBSTACLE_LAYERS:
            yield layer


def _active(named: dict[str, Parameter]) -> list[str]:
    """The layers that are listed and not switched off."""
    listed = [item.text for key in ("plugins", "filters") if key in named for item in items(named[key])]
    return [layer for layer in listed if not _is_false(named.get(f"{layer}.enabled"))]


def _is_false(parameter: Parameter | None) -> bool:
    return parameter is not None and parameter.value.data is False


def _observations(params: Params, named: dict[str, Parameter], layer: str) -> Iterator[NavigationProblem]:
    sources = named.get(f"{layer}.observation_sources")
    if sources is None or not isinstance(sources.value.data, str) or "$" in sources.value.data:
        return
    listed = sources.value.data.split()
    alone = {source for source in listed if not any(name.startswith(f"{layer}.{source}.") for name in named)}
    for source in listed:
        prefix = f"{layer}.{source}."
        if source in alone:
            if not params.named_elsewhere(source, {sources.span.source}):
                yield _without_section(named, layer, sources, source, alone=alone.issuperset(listed))
            continue
        seen = named.get(f"{prefix}data_type")
        if seen is not None and isinstance(seen.value.data, str) and seen.value.data not in _SEEN:
            if "$" not in seen.value.data:
                yield NavigationProblem("type", seen.span, source, seen.value.data)
        marked, cleared = named.get(f"{prefix}obstacle_max_range"), named.get(f"{prefix}raytrace_max_range")
        far = number_of(marked) if marked is not None else _OBSTACLE
        clear = number_of(cleared) if cleared is not None else _RAYTRACE
        where = cleared or marked
        if where is None or far is None or clear is None or clear >= far or _is_off(named, prefix):
            continue
        other = marked.span if marked is not None and where is cleared else None
        yield NavigationProblem("ranges", where.span, source, f"{clear:g} m, {far:g} m", other)


def _without_section(
    named: dict[str, Parameter], layer: str, where: Parameter, source: str, alone: bool
) -> NavigationProblem:
    """A source that is listed and has no section: where the layer has one that is not listed, it may be meant."""
    listed = str(where.value.data).split()
    spare = {
        name: named[f"{layer}.{name}.{key}"]
        for key in ("data_type", "topic")
        for name in _sections(named, layer, key)
        if name not in listed
    }
    if spare:
        meant = next(iter(nearest(source, spare, 4)), next(iter(spare)))
        return NavigationProblem("unlisted", where.span, source, meant, spare[meant].span)
    return NavigationProblem("source" if alone else "stray", where.span, source, layer)


def _sections(named: dict[str, Parameter], layer: str, key: str) -> Iterator[str]:
    """The sections right below a layer that have a parameter."""
    for name in named:
        if name.startswith(f"{layer}.") and name.endswith(f".{key}") and name.count(".") == layer.count(".") + 2:
            yield name[len(layer) + 1 : -len(key) - 1]


def _never_cleared(named: dict[str, Parameter], layer: str) -> Iterator[NavigationProblem]:
    """A layer whose sources all mark and none of which clears, as by default (obstacle_layer.cpp)."""
    listed, enabled = named.get(f"{layer}.observation_sources"), named.get(f"{layer}.enabled")
    sources = str(listed.value.data).split() if listed is not None else []
    if listed is None or (enabled is not None and enabled.value.data is not True):
        return
    marking = [named.get(f"{layer}.{source}.marking") for source in sources]
    clearing = [named.get(f"{layer}.{source}.clearing") for source in sources]
    given = [each for each in clearing if each is not None]
    if given and all(each.value.data is False for each in given):
        if all(each is None or each.value.data is True for each in marking):
            yield NavigationProblem("clearing", given[0].span, layer, ", ".join(sources), listed.span)


def _is_off(named: dict[str, Parameter], prefix: str) -> bool:
    """Whether a source does not mark, or does not clear anything at all."""
    flags = [named.get(f"{prefix}{flag}") for flag in ("marking", "clearing")]
    return flags[1] is None or any(each is not None and each.value.data is not True for each in flags)


def _smoother(params: Params, file: ParameterFile, block: Block) -> Iterator[NavigationProblem]:
    named = by_name(block)
    for name, sign in _SIGNS:
        numbers = numbers_of(named.get(name))
        wrong = [f"{each:g}" for each in numbers if each * sign < 0]
        if wrong:
            yield NavigationProblem("sign", named[name].span, name, ", ".join(wrong))
    yield from _unable_to_turn(named)
    if _may_smooth(params, file):
        yield from slower_smoother(file, block)
    counts = {name: len(numbers) for name in _LIMITS if (numbers := numbers_of(named.get(name)))}
    spatial = [count for count in counts.values() if count == _SPATIAL]
    axes = _SPATIAL if 2 * len(spatial) > len(counts) else _PLANAR
    for name, count in counts.items():
        if count != axes:
            yield NavigationProblem("length", named[name].span, name, f"{count} numbers instead of {axes}")


def _unable_to_turn(named: dict[str, Parameter]) -> Iterator[NavigationProblem]:
    """Limits of zero for the yaw, both ways, while another axis may move."""
    most, least = (numbers_of(named.get(name)) for name in ("max_velocity", "min_velocity"))
    if len(most) == len(least) and len(most) in (_PLANAR, _SPATIAL) and most[-1] == least[-1] == 0 and any(most):
        yield NavigationProblem(
            "turn", named["max_velocity"].span, "max_velocity", named["max_velocity"].text, named["min_velocity"].span
        )


def _monitor(params: Params, file: ParameterFile, block: Block) -> Iterator[NavigationProblem]:
    """Polygons that are listed and have no section, in which their type must be given."""
    listed = by_name(block).get("polygons")
    if listed is None or any("$" in item.text for item in items(listed)):
        return
    sections = {
        str(each.name).partition(".")[0] for every in file.blocks for each in every.parameters if each is not listed
    }
    for item in items(listed):
        if item.text not in sections and not params.named_elsewhere(item.text, {file.source}):
            yield NavigationProblem("polygon", item.span, item.text, block.node_name)
    yield from hidden_zones(file, block)


def _controllers(params: Params, file: ParameterFile, block: Block) -> Iterator[NavigationProblem]:
    """What a server does with its controllers; also critics that they do not have, and that nothing else of the tree
    names, as a package with critics of its own does."""
    yield from short_steps(block)
    yield from blind_controllers(block)
    yield from lost_reversals(block, params.distribution)
    named = by_name(block)
    for section, each, known in critics_of(named):
        for item in items(each):
            critic = plain(item.text, known)
            is_plain = item.text.isidentifier() and f"{section}.{item.text}.class" not in named
            if is_plain and critic not in known and not params.named_elsewhere(item.text, {file.source}):
                yield NavigationProblem(
                    "critic", item.span, item.text, next(iter(nearest(critic, sorted(known), 4)), "")
                )


def _amcl(params: Params, file: ParameterFile, block: Block) -> Iterator[NavigationProblem]:
    named = by_name(block)
    yield from other_scan(params, file, block)
    pose = [named[name] for name in _COORDINATES if name in named and number_of(named[name])]
    if pose and "set_initial_pose" not in named and not params.named_elsewhere("set_initial_pose", {file.source}):
        yield NavigationProblem("pose", pose[0].span, str(pose[0].name), pose[0].text)
    least, most = (named.get(name) for name in ("min_particles", "max_particles"))
    if least is not None and most is not None:
        low, high = number_of(least), number_of(most)
        if low is not None and high is not None and low > high:
            yield NavigationProblem("particles", least.span, "min_particles", f"{low:g}, {high:g}", most.span)
    model = named.get("robot_model_type")
    if model is not None and model.value.data in _OLD_MODELS and _is_since_humble(params, file):
        yield NavigationProblem("model", model.span, str(model.value.data), _OLD_MODELS[str(model.value.data)])


def _recoveries(params: Params, file: ParameterFile, block: Block) -> Iterator[NavigationProblem]:
    """The section of the server that Humble calls behavior_server, where the file has none for that name, or one that
    lacks what this one says."""
    if not block.parameters or not _is_since_humble(params, file) or _starts_recoveries(params, file):
        return
    newer = [each for each in file.blocks if each.node_name == _BEHAVIORS]
    if not newer:
        yield NavigationProblem("section", block.key.span, block.node_name, _BEHAVIORS)
        return
    given = {name for each in newer for name in by_name(each)}
    named = by_name(block)
    lost = [name for name in _OF_BEHAVIORS if name in named and name not in given]
    lost = [name for name in lost if named[name].value.data != _OF_BEHAVIORS[name]]
    if lost:
        yield NavigationProblem("halves", block.key.span, block.node_name, ", ".join(lost), newer[0].key.span)


def _starts_recoveries(params: Params, file: ParameterFile) -> bool:
    """Whether a launch file starts a node of the old name, or nodes of which not all names are known."""
    return None in (names := _loading(params, file)) or _RECOVERIES in names


def _may_smooth(params: Params, file: ParameterFile) -> bool:
    """Whether the smoother may run beside the controllers: no launch file of the tree starts these without it."""
    names = _loading(params, file)
    if "velocity_smoother" in names:
        return True
    return "controller_server" not in names and not _is_launched_without(
        params, "controller_server", "velocity_smoother"
    )


def _is_launched_without(params: Params, name: str, other: str) -> bool:
    """Whether launch files of the tree name one word and none of them another one."""
    texts = [each.text for each in params.files.of_kind(*LAUNCH)]
    return any(name in text for text in texts) and not any(other in text for text in texts)


def _loading(params: Params, file: ParameterFile) -> set[str | None]:
    """The names of the nodes that launch files give a file to."""
    names = (load.node.fqn for load in params.loads(file))
    return {str(name).rpartition("/")[2] if name is not None else None for name in names}


def _is_since_humble(params: Params, file: ParameterFile) -> bool:
    """Whether a file is for Humble or newer: its folder or the tree says so, or it is for a node that older ones do
    not have."""
    distribution = distros.named_in(os.path.basename(os.path.dirname(file.source.absolute))) or params.distribution
    if distribution is not None:
        return distribution not in _BEFORE_PLUGINS
    return any(block.node_name in _SINCE_HUMBLE for block in file.blocks)


_CHECKS: dict[str, Callable[[Params, ParameterFile, Block], Iterator[NavigationProblem]]] = {
    "controller_server": _controllers,
    "local_costmap": _costmap,
    "global_costmap": _costmap,
    "velocity_smoother": _smoother,
    "amcl": _amcl,
    "collision_monitor": _monitor,
    "collision_detector": _monitor,
    "bt_navigator": _navigator,
    _RECOVERIES: _recoveries,
}
