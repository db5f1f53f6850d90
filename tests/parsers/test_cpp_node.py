"""C++ sources of nodes: what the syntax tree shows, and that no text makes the reader fail."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.budget import OutOfTime
from bringup_lint.parsers.cpp_node import parse
from bringup_lint.source import Source
from tests.scenarios.test_growth import LOGARITHM
from tests.scenarios.test_growth import SIZES
from tests.scenarios.test_growth import counted
from tests.scenarios.test_growth import excess

NODE = """
#include "rclcpp/rclcpp.hpp"
using Scan = sensor_msgs::msg::LaserScan;
static const std::string GOAL = "goal";

Relay::Relay(const rclcpp::NodeOptions & options) : rclcpp::Node("relay", options)
{
  // Straße: create_publisher<Scan>("comment", 1)
  declare_parameter<std::string>("scan_topic", "scan");
  declare_parameter("rate", 12.5);
  this->declare_parameter("retries", 3);
  auto topic = get_parameter("scan_topic").as_string();
  scan_ = create_subscription<Scan>(topic, rclcpp::SensorDataQoS(), std::bind(&Relay::on_scan, this, _1));
  goal_ = node->template create_publisher<geometry_msgs::msg::Twist>(GOAL, rclcpp::QoS(1).transient_local());
  if (wanted_) {
    save_ = create_service<std_srvs::srv::Trigger>("~/save", [this](auto q, auto a) { sleep(2); });
  }
  timer_ = create_wall_timer(std::chrono::milliseconds(250), std::bind(&Relay::tick, this));
  port_ = open("/dev/ttyUSB1", O_RDWR);
}
RCLCPP_COMPONENTS_REGISTER_NODE(Relay)
"""


def test_name_from_a_call() -> None:
    """A parameter may give a name without a variable between them; one that gives a part of it does not."""
    text = """
#include "rclcpp/rclcpp.hpp"
Mower::Mower() : rclcpp::Node("mower") {
  declare_parameter("odometry", "odom");
  declare_parameter<std::string>("blade");
  declare_parameter("place", "left");
  a_ = create_publisher<std_msgs::msg::Bool>(get_parameter("odometry").as_string(), 1);
  b_ = create_publisher<std_msgs::msg::Bool>(this->get_parameter("blade").get_value<std::string>(), 1);
  c_ = create_publisher<std_msgs::msg::Bool>(
    get_parameter("place").as_string() + get_parameter("blade").as_string(), 1);
  d_ = create_publisher<std_msgs::msg::Bool>(get_parameter(name_).as_string(), 1);
}
"""
    found = [(each.name, each.parameter) for each in parse(Source("mower.cpp", text)).endpoints]
    assert found == [("odom", "odometry"), (None, "blade"), (None, None), (None, None)]


def test_node() -> None:
    node = parse(Source("relay.cpp", NODE))
    found = [(each.role, each.type, each.name, each.parameter, each.conditional) for each in node.endpoints]
    assert found == [
        ("subscription", "sensor_msgs/msg/LaserScan", "scan", "scan_topic", False),
        ("publisher", "geometry_msgs/msg/Twist", "goal", None, False),
        ("service", "std_srvs/srv/Trigger", "~/save", None, True),
    ]
    assert [each.span.text for each in node.names] == ["relay"]
    assert [(each.name, each.default) for each in node.parameters] == [
        ("scan_topic", "scan"),
        ("rate", 12.5),
        ("retries", 3),
    ]
    assert [(each.period, each.callback) for each in node.timers] == [(0.25, "tick")]
    assert [(each.name, each.required) for each in node.reads] == [("scan_topic", True)]
    assert [each.what for each in node.waits] == ["sleep(2 s)"]
    assert (node.devices, node.components) == (["/dev/ttyUSB1"], ["Relay"])


def test_qos() -> None:
    scan, goal, _ = parse(Source("relay.cpp", NODE)).endpoints
    assert scan.qos is not None and (scan.qos.reliability, scan.qos.depth) == ("BEST_EFFORT", 5)
    assert goal.qos is not None and (goal.qos.durability, goal.qos.depth) == ("TRANSIENT_LOCAL", 1)


def test_qos_that_calls_change() -> None:
    """What statements call on a local variable counts up to where it is used; a condition or a loop leaves it open."""
    text = """
#include "rclcpp/rclcpp.hpp"
rclcpp::QoS shared = rclcpp::QoS(1).best_effort();
Mower::Mower() : rclcpp::Node("mower"), out_(create_publisher<std_msgs::msg::Bool>("a", shared)) {
  auto qos = rclcpp::QoS(rclcpp::KeepLast(1));
  qos.best_effort();
  b_ = create_publisher<std_msgs::msg::Bool>("b", qos);
  qos.reliable().transient_local();
  c_ = create_publisher<std_msgs::msg::Bool>("c", qos);
  d_ = create_publisher<std_msgs::msg::Bool>("d", qos.best_effort());
  auto profile = qos.get_rmw_qos_profile();
}
void Mower::open(rclcpp::QoS qos) {
  e_ = create_publisher<std_msgs::msg::Bool>("e", qos);
  rclcpp::QoS own(10);
  if (late_) { own.best_effort(); }
  f_ = create_publisher<std_msgs::msg::Bool>("f", own);
  for (int i = 0; i < 2; i++) {
    auto each = rclcpp::QoS(1);
    each.best_effort();
    g_ = create_publisher<std_msgs::msg::Bool>("g", each);
  }
  auto late = [this]() { auto qos = rclcpp::SensorDataQoS(); h_ = create_publisher<std_msgs::msg::Bool>("h", qos); };
}
"""
    found = {str(each.name): each.qos for each in parse(Source("mower.cpp", text)).endpoints}
    assert {name: qos and (qos.reliability, qos.durability) for name, qos in found.items()} == {
        "a": ("BEST_EFFORT", "VOLATILE"),
        "b": ("BEST_EFFORT", "VOLATILE"),
        "c": ("RELIABLE", "TRANSIENT_LOCAL"),
        "d": ("BEST_EFFORT", "TRANSIENT_LOCAL"),
        "e": None,
        "f": None,
        "g": None,
        "h": ("BEST_EFFORT", "VOLATILE"),
    }


@pytest.mark.parametrize(
    "written, policies",
    [
        ("rclcpp::QoS(rclcpp::KeepLast(5), rmw_qos_profile_sensor_data)", ("BEST_EFFORT", "VOLATILE")),
        (
            "rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(rmw_qos_profile_default), rmw_qos_profile_default)",
            ("RELIABLE", "VOLATILE"),
        ),
        ("rclcpp::QoS(rclcpp::KeepAll(), rmw_qos_profile_of_others)", None),
        ("rclcpp::QoS(rclcpp::KeepAll())", ("RELIABLE", "VOLATILE")),
        ("rclcpp::QoS(1).reliability(rclcpp::ReliabilityPolicy::BestEffort)", ("BEST_EFFORT", "VOLATILE")),
        ("rclcpp::QoS(1).durability(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL)", ("RELIABLE", "TRANSIENT_LOCAL")),
        ("rclcpp::QoS(1).reliability(asked_)", (None, "VOLATILE")),
    ],
)
def test_qos_of_rmw(written: str, policies: tuple[str | None, str] | None) -> None:
    text = f'#include "rclcpp/rclcpp.hpp"\nvoid f() {{ create_publisher<std_msgs::msg::Bool>("a", {written}); }}\n'
    (made,) = parse(Source("mower.cpp", text)).endpoints
    assert (made.qos and (made.qos.reliability, made.qos.durability)) == policies


def test_names_of_macros() -> None:
    text = """
#include "rclcpp/rclcpp.hpp"
#define PREFIX "mower/"
#define TOPIC(name) PREFIX name
#define TWICE "a"
#define TWICE "b"
#define NUMBER 5
void f() {
  create_publisher<std_msgs::msg::Bool>(PREFIX "state", 1);
  create_publisher<std_msgs::msg::Bool>(TOPIC("blade"), 1);
  create_publisher<std_msgs::msg::Bool>(PREFIX, 1);
  create_publisher<std_msgs::msg::Bool>("left" "_wheel", 1);
  create_publisher<std_msgs::msg::Bool>(TWICE, 1);
  create_publisher<std_msgs::msg::Bool>(NUMBER, 1);
  create_publisher<std_msgs::msg::Bool>(PREFIX("x"), 1);
  create_publisher<std_msgs::msg::Bool>(named("x"), 1);
}
"""
    found = [each.name for each in parse(Source("mower.cpp", text)).endpoints]
    assert found == ["mower/state", "mower/blade", "mower/", "left_wheel", None, None, None, None]


def test_a_macro_of_much_text_is_no_name() -> None:
    text = f"""
#include "rclcpp/rclcpp.hpp"
#define LONG(a) {"a " * 5000}
#define MANY(a) {"a " * 30}
void f() {{
  create_publisher<std_msgs::msg::Bool>(LONG("x"), 1);
  create_publisher<std_msgs::msg::Bool>(MANY("x"), 1);
}}
"""
    assert [each.name for each in parse(Source("mower.cpp", text)).endpoints] == [None, None]


def test_an_error_costs_its_construct() -> None:
    text = NODE.replace('declare_parameter("rate", 12.5);', "declare_parameter(((;")
    assert len(parse(Source("relay.cpp", text)).endpoints) == 3


def test_macros_of_visibility() -> None:
    text = """
class DRIVE_PUBLIC Drive : public rclcpp::Node
{
public:
  DRIVE_PUBLIC
  explicit Drive(const rclcpp::NodeOptions & options) : Node("drive", options)
  {
    declare_parameter("gain", 1.0);
  }
};
class BASE_EXPORT Arm final : public rclcpp_lifecycle::LifecycleNode {};
"""
    node = parse(Source("drive.hpp", text))
    assert node.classes == ["Drive", "Arm"]
    assert [each.span.text for each in node.names] == ["drive"]
    assert [each.name for each in node.parameters] == ["gain"]


@given(st.text(max_size=80), st.integers(0, len(NODE)), st.integers(0, 40))
def test_no_text_fails(text: str, at: int, size: int) -> None:
    broken = NODE[:at] + text + NODE[at + size :]
    node = parse(Source("relay.cpp", broken))
    for each in (*node.endpoints, *node.timers, *node.waits):
        assert 0 <= each.span.start <= each.span.end <= len(broken)
    assert all(each.span.text == each for each in node.devices)


def test_deep_nesting_is_left_out() -> None:
    deep = parse(Source("relay.cpp", NODE + "(" * 200_000))
    assert [problem.code for problem in deep.problems] == ["too-deep"]
    assert deep.endpoints == []


def test_nodes_that_are_variables() -> None:
    text = '#include "rclcpp/rclcpp.hpp"\nint main() { rclcpp::Node arm("arm"); rclcpp::Node leg{"leg"}; }\n'
    assert parse(Source("main.cpp", text)).names == ["arm", "leg"]


def subscriptions(count: int) -> str:
    """A class that keeps what it hears in one member for each topic, and sends all of them from many timers."""
    made = "".join(
        f'  s_ = create_subscription<geometry_msgs::msg::Twist>("t{n}", 10, std::bind(&A::on_{n}, this, _1));\n'
        f"  w_ = create_wall_timer(1s, std::bind(&A::at_{n}, this));\n"
        for n in range(count)
    )
    callbacks = "".join(
        f"void A::on_{n}(const Twist & msg) {{ last_{n}_ = msg.linear; }}\n"
        f"void A::at_{n}() {{ send(); pub_->publish(last_{n}_); }}\n"
        for n in range(count)
    )
    writes = "".join(f" write(last_{n}_);" for n in range(count))
    return f'A::A() : Node("a") {{\n{made}}}\n{callbacks}void A::send() {{{writes} }}\n'


def test_what_callbacks_keep_is_known_in_time_that_grows_as_the_file_does() -> None:
    sources = [Source("a.cpp", subscriptions(20 * size)) for size in SIZES]
    assert len(parse(sources[0]).kept) == 20
    calls = [counted(lambda source=source: parse(source))["parsers/cpp_node"] for source in sources]  # type: ignore[misc]
    assert excess(*calls) <= LOGARITHM


def test_recovery_from_errors_ends() -> None:
    with pytest.raises(OutOfTime):
        parse(Source("relay.cpp", NODE + "<!-- " * 20_000))


def test_a_duration_of_very_many_digits_is_no_small_one() -> None:
    text = f"#include <rclcpp/rclcpp.hpp>\nvoid f(rclcpp::Node &) {{ g(rclcpp::Duration(0, {'1' * 5000})); }}\n"
    assert not parse(Source("rover.cpp", text)).durations
    (short,) = parse(Source("rover.cpp", text.replace("1" * 5000, "100"))).durations
    assert short.number == "100"


def test_profiles_of_which_a_file_makes_very_many_by_one_name_are_not_known() -> None:
    made = 'rclcpp::QoS depth(1);\nqueue_ = create_publisher<std_msgs::msg::String>("depth", depth);\n'
    endpoints = parse(Source("rover.cpp", f"class A : rclcpp::Node {{ void f() {{\n{made * 101} }} }};")).endpoints
    assert len(endpoints) == 101
    assert not any(each.qos for each in endpoints)
