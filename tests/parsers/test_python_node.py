"""Python node sources: classes, endpoints, parameters, and the quality of service that is written in them."""

from __future__ import annotations

import textwrap

import pytest
from hypothesis import HealthCheck
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.discover.kinds import kind_of
from bringup_lint.model.node_source import INFINITE
from bringup_lint.model.node_source import LINEAGE
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.node_source import Qos
from bringup_lint.parsers.python_node import parse
from bringup_lint.source import Located
from bringup_lint.source import Source

HEAD = """\
import functools
import rclpy
import rclpy.qos
from geometry_msgs.msg import Twist
from rclpy.action import ActionServer
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from rclpy.qos import QoSPresetProfiles, QoSProfile, QoSReliabilityPolicy
from rclpy.qos import DurabilityPolicy, HistoryPolicy, ReliabilityPolicy, qos_profile_sensor_data
from sensor_msgs.msg import LaserScan
"""


def read(body: str) -> NodeSource:
    return parse(Source("driver.py", HEAD + textwrap.dedent(body)))


def in_class(lines: str, before: str = "", body: str = "") -> NodeClass:
    """The class of a node whose constructor holds these lines."""
    text = textwrap.indent(textwrap.dedent(lines), " " * 8)
    file = read(f"{textwrap.dedent(before)}\nclass Driver(Node):\n{body}    def __init__(self):\n{text}\n")
    assert not file.problems
    return file.classes[0]


def only(lines: str, before: str = "", body: str = "") -> Endpoint:
    (endpoint,) = in_class(lines, before, body).endpoints
    return endpoint


def qos(expression: str, before: str = "", lines: str = "") -> Qos | None:
    return only(f"{lines}\nself.create_publisher(Twist, 'cmd_vel', {expression})", before).qos


def test_publisher() -> None:
    found = only("self.pub = self.create_publisher(Twist, 'cmd_vel', 10)")
    assert (found.role, found.type, found.name) == ("publisher", "geometry_msgs/msg/Twist", "cmd_vel")
    assert found.attribute == "self.pub"
    assert found.name.span.text == "cmd_vel"
    assert found.span.text == "self.create_publisher(Twist, 'cmd_vel', 10)"
    assert (found.method, found.conditional, found.lifecycle) == ("__init__", False, False)


def test_keywords() -> None:
    found = only("self.create_subscription(topic='scan', callback=self.hear, qos_profile=5, msg_type=LaserScan)")
    assert (found.role, found.type, found.name) == ("subscription", "sensor_msgs/msg/LaserScan", "scan")
    assert found.callback == "hear"
    assert found.qos.depth == 5


@pytest.mark.parametrize(
    ("name", "before", "body", "expected"),
    [
        ("TOPIC", "TOPIC = 'cmd_vel'", "", "cmd_vel"),
        ("TOPIC", "TOPIC = 'a'\nTOPIC = 'b'", "", None),
        ("TOPIC", "import os\nTOPIC = os.environ['TOPIC']", "", None),
        ("self.TOPIC", "", "    TOPIC = 'cmd_vel'\n", "cmd_vel"),
        ("Driver.TOPIC", "", "    TOPIC = 'cmd_vel'\n", "cmd_vel"),
        ("f'{SIDE}/cmd_vel'", "SIDE = 'left'", "", "left/cmd_vel"),
        ("SIDE + '/cmd_vel'", "SIDE = 'left'", "", "left/cmd_vel"),
        ("f'{SIDE!r}/cmd_vel'", "SIDE = 'left'", "", None),
        ("'%s/cmd_vel' % SIDE", "SIDE = 'left'", "", None),
        ("topic", "", "", None),
    ],
)
def test_names_of_constants(name: str, before: str, body: str, expected: str | None) -> None:
    assert only(f"self.create_publisher(Twist, {name}, 10)", before, body).name == expected


def test_attribute_assigned_once_and_twice() -> None:
    lines = "self.topic = 'cmd_vel'\nself.create_publisher(Twist, self.topic, 10)"
    assert only(lines).name == "cmd_vel"
    assert only(lines, body="    def reset(self):\n        self.topic = 'other'\n").name is None


@pytest.mark.parametrize(
    "read_it",
    [
        "self.get_parameter('topic').value",
        "self.get_parameter('topic').get_parameter_value().string_value",
        "str(self.get_parameter('topic').value)",
    ],
)
def test_name_of_a_parameter(read_it: str) -> None:
    node = in_class(f"self.declare_parameter('topic', 'cmd_vel')\nself.create_publisher(Twist, {read_it}, 10)")
    (found,) = node.endpoints
    assert (found.name, found.parameter) == ("cmd_vel", "topic")
    assert node.parameters["topic"].default == "cmd_vel"


def test_parameter_without_literal_default() -> None:
    lines = "topic = self.declare_parameter('topic', rclpy.Parameter.Type.STRING).value"
    found = only(f"{lines}\nself.create_publisher(Twist, topic, 10)")
    assert (found.name, found.parameter) == (None, "topic")


def test_declare_parameters() -> None:
    node = in_class("self.declare_parameters('base', [('speed', 0.5), ('frame', 'base_link'), ('other', None)])")
    assert {name: each.default for name, each in node.parameters.items()} == {
        "base.speed": 0.5,
        "base.frame": "base_link",
        "base.other": None,
    }


RELIABLE = ("RELIABLE", "VOLATILE", "KEEP_LAST", 10)


@pytest.mark.parametrize(
    ("expression", "before", "expected"),
    [
        ("10", "", RELIABLE),
        ("DEPTH", "DEPTH = 10", RELIABLE),
        ("qos_profile_sensor_data", "", ("BEST_EFFORT", "VOLATILE", "KEEP_LAST", 5)),
        ("rclpy.qos.qos_profile_sensor_data", "", ("BEST_EFFORT", "VOLATILE", "KEEP_LAST", 5)),
        ("QoSPresetProfiles.SENSOR_DATA.value", "", ("BEST_EFFORT", "VOLATILE", "KEEP_LAST", 5)),
        ("QoSPresetProfiles.get_from_short_key('sensor_data')", "", None),
        ("QoSProfile(depth=10)", "", RELIABLE),
        ("rclpy.qos.QoSProfile(depth=10)", "", RELIABLE),
        ("PROFILE", "PROFILE = (QoSProfile(depth=10))", RELIABLE),
        (
            "QoSProfile(depth=1, durability=LATCHED, reliability=ReliabilityPolicy.BEST_EFFORT)",
            "LATCHED = DurabilityPolicy.TRANSIENT_LOCAL",
            ("BEST_EFFORT", "TRANSIENT_LOCAL", "KEEP_LAST", 1),
        ),
        (
            "QoSProfile(depth=1, reliability=QoSReliabilityPolicy.RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT)",
            "",
            ("BEST_EFFORT", "VOLATILE", "KEEP_LAST", 1),
        ),
        ("QoSProfile(history=HistoryPolicy.KEEP_ALL)", "", ("RELIABLE", "VOLATILE", "KEEP_ALL", 10)),
        ("QoSProfile(depth=n, reliability=chosen())", "", (None, "VOLATILE", "KEEP_LAST", None)),
        ("QoSProfile(**settings)", "", (None, None, None, None)),
        ("chosen()", "", None),
        ("PROFILE", "PROFILE = QoSProfile(depth=1)\nPROFILE = QoSProfile(depth=2)", None),
        (
            "PROFILE",
            "PROFILE = QoSProfile(depth=10)\nPROFILE.reliability = ReliabilityPolicy.BEST_EFFORT",
            ("BEST_EFFORT", "VOLATILE", "KEEP_LAST", 10),
        ),
    ],
)
def test_qos(expression: str, before: str, expected: tuple | None) -> None:
    found = qos(expression, before)
    assert (found and (found.reliability, found.durability, found.history, found.depth)) == expected


def test_qos_changed_between_making_and_use() -> None:
    found = qos("profile", lines="profile = QoSProfile(depth=1)\nprofile.durability = DurabilityPolicy.TRANSIENT_LOCAL")
    assert found.durability == "TRANSIENT_LOCAL"
    lines = "profile = QoSProfile(depth=1)\nif fast:\n    profile.reliability = ReliabilityPolicy.BEST_EFFORT"
    assert qos("profile", lines=lines).reliability is None
    later = in_class(
        "profile = QoSProfile(depth=1)\nself.create_publisher(Twist, 'a', profile)\n"
        "profile.reliability = ReliabilityPolicy.BEST_EFFORT\nself.create_publisher(Twist, 'b', profile)"
    )
    assert [each.qos.reliability for each in later.endpoints] == ["RELIABLE", "BEST_EFFORT"]


def test_qos_times() -> None:
    found = qos("QoSProfile(depth=1, deadline=Duration(seconds=1, nanoseconds=500_000_000))")
    assert (found.deadline, found.lease, found.liveliness) == (1.5, INFINITE, "SYSTEM_DEFAULT")
    assert qos("QoSProfile(depth=1, deadline=Duration(seconds=period))").deadline is None


def test_node_names() -> None:
    file = read(
        """
        class Plain(Node):
            def __init__(self):
                super().__init__('plain', namespace='arm')

        class Given(LifecycleNode):
            def __init__(self, name='given', **rest):
                Node.__init__(self, name, **rest)

        class Child(Given):
            def __init__(self):
                super().__init__(name='child')

        class Twice(Node):
            def __init__(self, name):
                super().__init__(name)

        class Once(Node):
            def __init__(self, name):
                super().__init__(name)

        def main():
            Twice('a'), Twice('b'), Once('only')
            single = rclpy.create_node('single')
            single.create_publisher(Twist, 'cmd_vel', 1)
            handed(single)

        def handed(node):
            node.create_publisher(Twist, 'stray', 1)
        """
    )
    names = {each.name: each.node_name for each in file.classes}
    assert names == {
        "Plain": "plain",
        "Given": "given",
        "Child": "child",
        "Twice": None,
        "Once": "only",
        None: "single",
    }
    assert file.class_named("Plain").namespace == "arm"
    assert [each.name for each in file.classes if each.is_lifecycle] == ["Given", "Child"]
    assert [each.name for each in file.classes[-1].endpoints] == ["cmd_vel"]
    assert [each.name for each in file.strays] == ["stray"]


def test_classes_that_are_no_nodes() -> None:
    file = read(
        """
        import threading
        from .base import Base
        class Worker(threading.Thread): pass
        class Plain: pass
        class Perhaps(Base): pass
        """
    )
    assert [(each.name, each.is_node, each.bases) for each in file.classes] == [("Perhaps", None, (".base.Base",))]


def test_callbacks_and_groups() -> None:
    node = in_class(
        """
        group = ReentrantCallbackGroup()
        self.own = MutuallyExclusiveCallbackGroup()
        self.create_timer(1 / 20, self.tick, callback_group=self.own)
        self.create_subscription(LaserScan, 'scan', functools.partial(self.hear, 'front'), 10, callback_group=group)
        self.create_subscription(LaserScan, 'scan', lambda message: self.hear(message), 10)
        ActionServer(self, Dock, 'dock', self.dock, cancel_callback=self.cancel)
        self.add_on_set_parameters_callback(self.changed)
        """
    )
    assert [(each.role, each.name, each.group and each.group.reentrant) for each in node.callbacks] == [
        ("timer", "tick", False),
        ("subscription", "hear", True),
        ("subscription", None, None),
        ("action", "dock", None),
        ("action-step", "cancel", None),
        ("parameters", "changed", None),
    ]
    assert [each.period for each in node.timers] == [0.05]
    assert node.endpoints[-1].role == "action-server"


def test_broken_and_odd_files_have_problems() -> None:
    (problem,) = parse(Source("driver.py", "import rclpy\nclass (:\n")).problems
    assert (problem.code, problem.where.line) == ("syntax", 2)
    assert parse(Source("driver.py", "")).classes == []


@pytest.mark.parametrize(
    ("path", "head", "kind"),
    [
        ("src/driver/driver/node.py", "#!/usr/bin/env python3\nimport rclpy\n", "python-node"),
        ("src/driver/driver/node.py", "from rclpy.node import Node\n", "python-node"),
        ("src/driver/driver/node.py", "import sys, rclpy\n", "python-node"),
        ("src/driver/driver/node.py", "try:\n    import rclpy\nexcept ImportError:\n    pass\n", "python-node"),
        ("src/driver/scripts/node", "#!/usr/bin/env python3\nimport rclpy\n", "python-node"),
        ("src/driver/scripts/node", "import rclpy\n", ""),
        ("src/driver/driver/node.py", "import rospy\n", ""),
        ("src/driver/driver/node.py", "import rclpy_message_converter\n", ""),
        ("src/driver/driver/node.py", '"""Speaks of rclpy."""\n', ""),
        ("src/driver/launch/robot.launch.py", "import launch\nimport rclpy\n", "launch-python"),
        ("src/driver/setup.py", "import rclpy\nsetup()\n", "setup-py"),
        ("docs/rclpy.md", "import rclpy\n", ""),
    ],
)
def test_kind(path: str, head: str, kind: str) -> None:
    assert kind_of(path, lambda: head) == kind


def spans(file: NodeSource):
    for node in file.classes:
        yield node.span
        for each in (*node.endpoints, *node.timers, *node.callbacks, *node.parameters.values(), *node.methods.values()):
            yield each.span
        for endpoint in node.endpoints:
            yield from (text.span for text in (endpoint.name, endpoint.parameter) if isinstance(text, Located))
            yield from (endpoint.qos.span,) if endpoint.qos else ()


PIECES = [
    "class A(Node):\n",
    "    def __init__(self):\n",
    "        super().__init__('a')\n",
    "        self.x = self.create_publisher(Twist, 'ünï', qos)\n",
    "        self.declare_parameter('p', 'v')\n",
    "        qos = QoSProfile(depth=1)\n",
    "        qos.depth = qos.depth\n",
    "a = b + b\n",
    "b = a + a\n",
    "rclpy.create_node(f'{a}')\n",
    "try:\n    pass\nexcept E as a:\n    pass\n",
    "\t",
    "\\\n",
    "'''",
    "\r",
    "\ufeff",
]


@settings(suppress_health_check=list(HealthCheck))
@given(st.lists(st.one_of(st.sampled_from(PIECES), st.text(max_size=12)), max_size=12).map("".join), st.booleans())
def test_nothing_makes_the_parser_raise(text: str, with_head: bool) -> None:
    source = Source("driver.py", HEAD + text if with_head else text)
    for span in spans(parse(source)):
        assert 0 <= span.start <= span.end <= len(source.text)


@pytest.mark.parametrize(
    "text",
    [
        "x = " + "(" * 5000,
        "x = " + "a." * 20000 + "b",
        "x = " + " + ".join(["'a'"] * 5000),
        "x = " + "-" * 3000 + "1",
        "if a:\n    pass\n" + "elif b:\n    pass\n" * 3000,
        "\n".join(f"a{i} = a{i + 1} + a{i + 1}" for i in range(60)) + "\nrclpy.create_node(a0)",
        "class A(B): pass\nclass B(A): pass\nA('x')",
        "self.create_publisher(" * 50 + ")" * 50,
    ],
    ids=["brackets", "attributes", "sum", "minus", "elif", "doubling", "bases", "nested"],
)
def test_hostile_files_are_read_quickly(text: str) -> None:
    parse(Source("driver.py", HEAD + text))


def test_names_that_constructors_are_given() -> None:
    file = read(
        """
        class Second(Node):
            def __init__(self, rate, name):
                super().__init__(name)

        class Own(Node):
            def __init__(self):
                Node.__init__(self, 'own')

        class Listed(Node):
            def __init__(self, name='default'):
                super().__init__(name)

        class Plain(Node):
            def __init__(self, *, name='plain'):
                super().__init__(name)

        def main(words):
            Second(10, 'second'), Listed(*words), Plain()
        """
    )
    names = {each.name: each.node_name for each in file.classes}
    assert names == {"Second": "second", "Own": "own", "Listed": None, "Plain": "plain"}


def test_lists_of_numbers_are_values() -> None:
    node = in_class("self.declare_parameter('gains', [0.5, 2.0])\nself.declare_parameter('mixed', [0.5, unknown()])")
    assert node.parameters["gains"].default == [0.5, 2.0]
    assert not isinstance(node.parameters["mixed"].default, list)


def test_transforms_are_published_in_every_state() -> None:
    found = only("self.tf = TransformBroadcaster(self)", "from tf2_ros import TransformBroadcaster")
    assert (found.name, found.lifecycle, found.implied) == ("/tf", False, True)


def test_a_depth_that_is_set_later_counts() -> None:
    found = qos("profile", lines="profile = QoSProfile(depth=1)\nprofile.depth = 7\nprofile.label = 'wheels'")
    assert found is not None and found.depth == 7


def test_a_long_line_of_classes_is_followed_as_far_as_a_robot_may_have_one() -> None:
    classes = "\n".join(f"class C{n}(C{n - 1}): pass" for n in range(1, 300))
    last = read(f"class C0(Node): pass\n{classes}\n").classes[-1]
    assert len(list(last.lineage)) == LINEAGE
