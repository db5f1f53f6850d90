"""Names, remappings and quality of service against the real rclpy."""

from __future__ import annotations

import itertools
import os
import shutil
import string
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.graph.topics.questions.compatibility import conflicts
from bringup_lint.graph.topics.resolved.names import complaint
from bringup_lint.graph.topics.resolved.names import expand
from bringup_lint.graph.topics.resolved.names import full_complaint
from bringup_lint.graph.topics.resolved.names import unknown_substitution
from bringup_lint.graph.topics.resolved.remapping import node_name
from bringup_lint.graph.topics.resolved.remapping import node_namespace
from bringup_lint.graph.topics.resolved.remapping import remap
from bringup_lint.graph.topics.resolved.remapping import remapping
from bringup_lint.model.node_source import INFINITE
from bringup_lint.model.node_source import Qos
from bringup_lint.source import Source
from tests.conftest import PROJECT
from tests.lint import lint
from tests.oracles.answers import Oracle
from tests.oracles.judges import endpoints
from tests.oracles.ros_python import rclpy

needs_rclpy = pytest.mark.skipif(rclpy() == "rclpy", reason="needs ros-jazzy-rclpy")

NOWHERE = Source("nowhere").whole
NAMES = st.lists(
    st.sampled_from(
        ["a", "b1", "_", "/", "//", "~", "{node}", "{ns}", "{x}", "{", "}", "-", ".", " ", "é", "1", "a" * 120]
    ),
    max_size=7,
).map("".join)
NAMESPACES = st.sampled_from(["/", "/r1", "/r1/arm"])


def refusal(check, *arguments) -> str | None:
    try:
        check(*arguments)
    except Exception as error:
        return str(error)
    return None


@needs_rclpy
@given(NAMES)
def test_names_are_valid_as_for_rcl(name: str) -> None:
    from rclpy.validate_topic_name import validate_topic_name

    assert (complaint(name) is None) == (refusal(validate_topic_name, name) is None), name


@needs_rclpy
@given(NAMES, NAMESPACES)
def test_names_are_expanded_as_by_rcl(name: str, namespace: str) -> None:
    from rclpy.expand_topic_name import expand_topic_name
    from rclpy.validate_full_topic_name import validate_full_topic_name

    try:
        expected = expand_topic_name(name, "planner", namespace)
    except Exception:
        expected = None
    found = expand(name, "planner", namespace)
    assert found == expected, name
    if found is None:
        assert complaint(name) or unknown_substitution(name)
    else:
        assert (full_complaint(found) is None) == (refusal(validate_full_topic_name, found) is None), found


@needs_rclpy
@pytest.mark.parametrize("length", [246, 247, 248])
def test_the_longest_name(length: int) -> None:
    from rclpy.validate_full_topic_name import validate_full_topic_name

    name = "/" + "x" * (length - 1)
    assert (full_complaint(name) is None) == (refusal(validate_full_topic_name, name) is None) == (length <= 247)


def duration(seconds: float):
    """None is what rclpy makes of a duration that is not set."""
    from rclpy.duration import Duration

    return Duration() if seconds == INFINITE else Duration(seconds=seconds)


def profiles():
    from rclpy.qos import DurabilityPolicy
    from rclpy.qos import LivelinessPolicy
    from rclpy.qos import QoSProfile
    from rclpy.qos import ReliabilityPolicy

    reliabilities = ("RELIABLE", "BEST_EFFORT", "SYSTEM_DEFAULT", "BEST_AVAILABLE")
    durabilities = ("VOLATILE", "TRANSIENT_LOCAL", "SYSTEM_DEFAULT", "BEST_AVAILABLE")
    livelinesses = ("AUTOMATIC", "MANUAL_BY_TOPIC", "SYSTEM_DEFAULT", "BEST_AVAILABLE")
    for reliability, durability, liveliness in itertools.product(reliabilities, durabilities, livelinesses):
        for deadline, lease in itertools.product((INFINITE, 1, 2.5), repeat=2):
            own = Qos(
                NOWHERE, reliability, durability, "KEEP_LAST", 5, deadline=deadline, liveliness=liveliness, lease=lease
            )
            yield (
                own,
                QoSProfile(
                    depth=5,
                    reliability=ReliabilityPolicy[reliability],
                    durability=DurabilityPolicy[durability],
                    liveliness=LivelinessPolicy[liveliness],
                    deadline=duration(deadline),
                    liveliness_lease_duration=duration(lease),
                ),
            )


@needs_rclpy
def test_profiles_match_as_for_rmw() -> None:
    """All combinations: a conflict exactly where the middleware reports an error."""
    from rclpy.qos import QoSCompatibility
    from rclpy.qos import qos_check_compatible

    every = list(profiles())
    simple = [pair for pair in every if pair[0].deadline == INFINITE and pair[0].lease == INFINITE]
    times = [
        pair
        for pair in every
        if (pair[0].reliability, pair[0].durability, pair[0].liveliness) == ("RELIABLE", "VOLATILE", "AUTOMATIC")
    ]
    checked = 0
    for pairs in (itertools.product(simple, simple), itertools.product(times, times), zip(every, reversed(every))):
        for (own_pub, real_pub), (own_sub, real_sub) in pairs:
            verdict, reason = qos_check_compatible(real_pub, real_sub)
            expected = verdict == QoSCompatibility.ERROR
            assert bool(list(conflicts(own_pub, own_sub))) == expected, (own_pub, own_sub, reason)
            checked += 1
    assert checked > 4000


RULES = (
    [],
    ["scan:=lidar/scan"],
    ["/r1/scan:=/front", "scan:=second"],
    ["other:scan:=wrong", "driver:scan:=~/mine"],
    ["rosservice://scan:=no", "rostopic://scan:=yes"],
    ["~/status:=status", "driver/x:=/y"],
    ["scan:=/deep/scan", "status:=scan"],
    ["__node:=renamed", "scan:=~/scan"],
    ["driver:__node:=renamed", "driver:scan:=unused", "renamed:scan:=used"],
    ["__ns:=/elsewhere", "scan:=moved"],
)
TOPICS = ("scan", "/scan", "/r1/scan", "~/status", "status", "{node}/x", "a/b")
PROGRAM = """
    import sys, rclpy
    from rcl_interfaces.msg import Log
    rclpy.init(args=sys.argv)
    node = rclpy.create_node("driver", namespace="/r1")
    print(node.get_name(), node.get_namespace())
    for name in sys.argv[sys.argv.index("--names") + 1 :]:
        print(node.create_publisher(Log, name, 10).topic_name)
"""


def topics_of(cases: list[list[str]], folder: Path) -> list[list[str]]:
    """The name and namespace of a real node under remappings, and the topics that it gets."""
    found = []
    for rules in cases:
        words = [word for rule in rules for word in ("-r", rule)]
        arguments = ["--ros-args", *words, "--", "--names", *TOPICS] if rules else ["--names", *TOPICS]
        found.append(run(PROGRAM, arguments, folder).splitlines())
    return found


def test_remappings_of_a_real_node(answers: Oracle, tmp_path: Path) -> None:
    cases = list(map(list, RULES))
    for rules, lines in answers.of("rcl/topics", rclpy(), cases, lambda cases: topics_of(cases, tmp_path)).pairs:
        read = [remapping(rule) for rule in rules]
        name = node_name(read, "driver")
        namespace = node_namespace(read, "/r1", "driver")
        topics = [remap(read, expand(topic, name, namespace), name, namespace).name for topic in TOPICS]
        assert [f"{name} {namespace}", *topics] == lines, rules


SIDES = (
    "a front-lidar/scan a//b front/ / ~ ~/x ~x 1a a/1b {node}/x /a/ a.b é __x /front/1 ~/ a~b ~a/b /~/x * /a/*/b **/x"
    " rostopic://x a:b _ 1 /1 n:x a__b _x a/_b __ a_ ~/__x A1 x__ ~/a/b /a/b/c"
).split()
REMAPPED = """
    import sys, rclpy
    from rcl_interfaces.msg import Log
    for rule in sys.argv[1:]:
        context = rclpy.Context()
        try:
            rclpy.init(args=["driver", "--ros-args", "-r", rule], context=context)
        except Exception:
            print("refused")
            continue
        node = rclpy.create_node("driver", namespace="/r1", context=context)
        print(node.create_publisher(Log, "scan", 10).topic_name)
        context.try_shutdown()
"""


@pytest.mark.parametrize(("pattern", "record"), [("scan:={}", "targets"), ("{}:=other", "sources")])
def test_remappings_are_refused_as_by_rcl(pattern: str, record: str, answers: Oracle, tmp_path: Path) -> None:
    texts = [pattern.replace("{}", side) for side in SIDES]
    given = answers.of(f"rcl/{record}", rclpy(), texts, lambda texts: run(REMAPPED, texts, tmp_path).splitlines())
    for text, real in given.pairs:
        rule = remapping(text)
        assert (remap([rule], "/r1/scan", "driver", "/r1").name if rule else "refused") == real, text


def run(program: str, arguments: list[str], folder: Path) -> str:
    environment = {
        **os.environ,
        "ROS_LOG_DIR": str(folder),
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        "ROS_DOMAIN_ID": "77",
    }
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(program), *arguments],
        capture_output=True,
        text=True,
        env=environment,
        timeout=60,
        check=True,
    )
    return done.stdout


DELIVERY = """
    import os, sys, time, rclpy
    from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
    from rcl_interfaces.msg import Log
    offered, asked = (word.split(",") for word in sys.argv[1:3])
    def profile(reliability, durability):
        return QoSProfile(depth=5, reliability=ReliabilityPolicy[reliability], durability=DurabilityPolicy[durability])
    rclpy.init()
    talker, listener = rclpy.create_node("talker"), rclpy.create_node("listener")
    heard, (said, wanted) = [], (f"{name}_{os.getpid()}" for name in sys.argv[3:5])  # others are tried at the same time
    publisher = talker.create_publisher(Log, said, profile(*offered))
    listener.create_subscription(Log, wanted, heard.append, profile(*asked))
    end = time.monotonic() + 3
    while not heard and time.monotonic() < end:
        publisher.publish(Log(msg="battery low"))
        rclpy.spin_once(listener, timeout_sec=0.05)
    print(bool(heard))
"""


@needs_rclpy
@pytest.mark.parametrize(
    ("offered", "asked"),
    [
        (("RELIABLE", "VOLATILE"), ("BEST_EFFORT", "VOLATILE")),
        (("BEST_EFFORT", "VOLATILE"), ("RELIABLE", "VOLATILE")),
        (("RELIABLE", "VOLATILE"), ("RELIABLE", "TRANSIENT_LOCAL")),
        (("RELIABLE", "TRANSIENT_LOCAL"), ("RELIABLE", "VOLATILE")),
    ],
)
def test_data_arrives_only_without_a_conflict(offered: tuple[str, str], asked: tuple[str, str], tmp_path: Path) -> None:
    heard = run(DELIVERY, [",".join(offered), ",".join(asked), "alarm", "alarm"], tmp_path).strip() == "True"
    assert heard == (not list(conflicts(Qos(NOWHERE, *offered), Qos(NOWHERE, *asked))))


@needs_rclpy
def test_data_arrives_under_a_corrected_name(tmp_path: Path) -> None:
    tree = shutil.copytree(PROJECT / "fixtures/node/topic_typo/bad_outvoted", tmp_path / "tree")
    before = names_between(tree)
    lint("--fix", "--unsafe-fixes", "--select", "node/topic-typo", cwd=tree)
    profile = "RELIABLE,VOLATILE"
    heard = [run(DELIVERY, [profile, profile, *names], tmp_path).strip() for names in (before, names_between(tree))]
    assert heard == ["False", "True"]


def names_between(tree: Path) -> list[str]:
    """What the publisher of the tree and its subscriber call their topic."""
    nodes = (tree / f"mower/mower/{name}.py" for name in ("follow_wire", "base"))
    return [name for node in nodes for name in endpoints(node.read_text())]


@given(st.text(alphabet=string.ascii_lowercase + "/_:=~{}", max_size=14))
def test_rules_are_read_without_failing(text: str) -> None:
    rule = remapping(text)
    assert rule is None or remap([rule], "/a/b", "n", "/a") is not None
