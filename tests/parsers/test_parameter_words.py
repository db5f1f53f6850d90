"""The texts by which sources name parameters, in Python and C++, and whether all names are among them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.parameter_words import ParameterWords
from bringup_lint.parsers.cpp_node.parameter_words import parse as parse_cpp
from bringup_lint.parsers.python_node.parameter_words import parse as parse_python
from bringup_lint.source import Source


def python(text: str) -> ParameterWords:
    return parse_python(Source("node.py", text))


def cpp(text: str) -> ParameterWords:
    return parse_cpp(Source("node.cpp", text))


@pytest.mark.parametrize(
    "text",
    [
        "node.declare_parameter('gain', 1.0)",
        "node.declare_parameters('', [('gain', 1.0)])",
        "def read(name):\n    node.declare_parameter(name)\nread('gain')",
        "for name in ('gain', 'rate'):\n    node.declare_parameter(name)",
        "NAMES = {'gain': 1}\nfor name, value in NAMES.items():\n    node.declare_parameter(name, value)",
        "GAIN = 'gain'\nnode.declare_parameter(GAIN)",
    ],
)
def test_names_that_are_written(text: str) -> None:
    words = python(text)
    assert not words.open
    assert words.name("gain") and not words.name("rope")


@pytest.mark.parametrize(
    "text",
    [
        "node.declare_parameter(names[0])",
        "node.declare_parameters('', read_file())",
        "def read(name):\n    node.declare_parameter(name)\nfor name in load():\n    read(name)",
        "Node('n', allow_undeclared_parameters=True)",
        "def broken(:",
    ],
)
def test_names_that_come_from_elsewhere(text: str) -> None:
    assert python(text).open


def test_names_that_are_put_together() -> None:
    words = python("for side in SIDES:\n    node.declare_parameter(f'{side}_wheel.gain', 1)\nprint('%s_port' % side)")
    assert words.name("left_wheel.gain") and words.name("rear_port") and not words.name("left_arm")


def test_what_is_only_read_is_not_declared() -> None:
    words = python("'''rope'''\nnode.get_parameter('rope')\ntry:\n    node.get_parameter('drum')\nexcept E:\n    pass")
    assert not words.name("rope")
    assert [(each.name, each.required, each.name.span.text) for each in words.asked] == [
        ("rope", True, "'rope'"),
        ("drum", False, "'drum'"),
    ]


def test_cpp() -> None:
    text = """
    // declare_parameter("old", 1);
    const char * const GAIN = "gain";
    double read(const std::string & name) { return node->declare_parameter(name, 1.0); }
    void f() { declare_parameter(GAIN, 1.0); declare_parameter(prefix + "_port", 1); get_parameter("rope", rope_); }
    """
    words = cpp(text)
    assert not words.open
    assert words.name("gain") and words.name("left_port")
    assert not words.name("old") and not words.name("rope")
    assert [(each.name, each.required) for each in words.asked] == [("rope", False)]


@pytest.mark.parametrize(
    "text",
    [
        "void f() { for (const auto & name : names()) { declare_parameter(name, 1.0); } }",
        "void f() { declare_parameter(names[0], 1.0); }",
        "#define READ(x) \\\n  node->declare_parameter(#x, x)\n",
        "rclcpp::NodeOptions().allow_undeclared_parameters(true);",
    ],
)
def test_names_of_cpp_that_come_from_elsewhere(text: str) -> None:
    assert cpp(text).open


@given(st.text(max_size=200))
def test_no_text_fails(text: str) -> None:
    cpp(f'get_parameter("{text}')
    python(f"node.declare_parameter({text})")


@pytest.mark.parametrize(
    ("words", "names"),
    [
        (python("node.declare_parameter('gain', 1.0)\nprint('rope')"), {"gain"}),
        (python("node.declare_parameter(name='gain', value=1.0)"), {"gain"}),
        (python("node.declare_parameters('', (('gain', 1), ('rate', 2)))"), {"gain", "rate"}),
        (python("node.declare_parameters('', [('gain', 1), make()])"), None),
        (python("node.declare_parameters('arm', [('gain', 1)])"), None),
        (python("node.declare_parameters('', GAINS)\nGAINS = [('gain', 1)]"), None),
        (python("node.declare_parameter(f'{side}_gain', 1)"), None),
        (python("read_param('gain')"), None),
        (python("node.get_parameter('gain')"), set()),
        (cpp('declare_parameter("gain", 1.0); log("rope");'), {"gain"}),
        (cpp('void f() { declare_parameter<int>("gain"); read_param("rope"); }'), None),
        (cpp('void f() { declare_parameters("", {{"gain", 1}}); }'), None),
        (cpp('void f() { declare_parameter(prefix + "gain", 1); }'), None),
        (cpp('log("rope");'), set()),
    ],
)
def test_declarations_are_all_names_where_each_is_written_in_its_call(
    words: ParameterWords, names: set[str] | None
) -> None:
    assert words.declared == names


def test_texts_count_where_one_source_of_a_program_makes_names() -> None:
    one, other = cpp('void f() { declare_parameter("gain"); log("rope"); }'), cpp('void f() { read_param("reel"); }')
    assert not one.name("rope")
    assert (one | other).name("rope")
