"""XML and YAML launch files, and the ``$(...)`` grammar that they share."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import FileDir
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import literal
from bringup_lint.parsers import launch_xml
from bringup_lint.parsers import launch_yaml
from bringup_lint.parsers.launch_frontend.substitutions import read
from bringup_lint.source import Located
from bringup_lint.source import Source
from tests.parsers.test_launch_python import check_spans


def value(text: str):
    source = Source("x.launch.xml", text)
    return read(Located(text, source.span(0, len(text))), LaunchFile(source, "xml"))


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("plain", Literal),
        ("$(var x)", Argument),
        ("$(var x y)", Argument),
        ("a$(var x)b", Concat),
        ("$(env X)", Env),
        ("$(find-pkg-share p)", PackageShare),
        ("$(dirname)", FileDir),
        ("$(eval '1 + 1')", Operation),
        ("$(not $(var x))", Operation),
        ("$(arg x)", Unknown),
        ("$(var x", Unknown),
        ("$(nothing)", Unknown),
        ("$", Literal),
        ("\\$(var x)", Literal),
        ("$(var $(var y))", Unknown),
    ],
)
def test_substitution(text: str, kind: type) -> None:
    assert type(value(text)) is kind


def test_arguments_of_substitutions_have_places() -> None:
    found = value("$(find-pkg-share my_robot)/config/$(var name 'a b').yaml")
    share, middle, name, end = found.parts
    assert literal(share.package).span.text == "my_robot"
    assert literal(middle) == "/config/"
    assert (str(name.name), literal(name.default)) == ("name", "a b")
    assert name.name.span.text == "name"
    assert literal(end) == ".yaml"


def test_nested_quotes() -> None:
    found = value('$(eval \'"$(var mode)" == "real"\')')
    assert isinstance(found, Operation)
    (expression,) = found.operands
    assert isinstance(expression, Concat)
    assert isinstance(expression.parts[1], Argument)


XML = """\
<launch>
  <arg name="rate" default="5"><choice value="5"/><choice value="6"/></arg>
  <group if="$(var on)">
    <node pkg="demo" exec="talker" name="chat" namespace="ns" args="-a $(var rate) 'b c'" respawn="true">
      <param name="rate" value="5"/>
      <param name="list" value="a;b" value-sep=";"/>
      <param name="word" value="5" type="str"/>
      <param from="/etc/x.yaml" allow_substs="true"/>
      <remap from="a" to="b"/>
      <env name="X" value="1"/>
    </node>
  </group>
</launch>
"""


def test_xml_node() -> None:
    file = launch_xml.parse(Source("x.launch.xml", XML))
    (node,) = (action for action in walk_actions(file.actions) if isinstance(action, Node))
    (declare,) = (action for action in walk_actions(file.actions) if isinstance(action, DeclareArgument))
    assert [literal(choice) for choice in declare.choices] == ["5", "6"]
    rate, listed, word, from_file = node.parameters
    assert rate.items[0][1].value == 5
    assert [item.value for item in listed.items[0][1].items] == ["a", "b"]
    assert word.items[0][1].type == "str"
    assert isinstance(from_file, ParameterFile)
    assert [literal(word) for word in node.arguments][-1] == "b c"
    assert literal(node.name).span.text == "chat"
    assert "respawn" in node.options
    assert [literal(part) for part in node.additional_env[0]] == ["X", "1"]
    assert file.problems == []


def test_yaml_node() -> None:
    text = 'launch:\n- node:\n    pkg: demo\n    exec: talker\n    name: "chat"\n    param:\n'
    text += "    - {name: a, value: [1, 2]}\n"
    file = launch_yaml.parse(Source("x.launch.yaml", text))
    (node,) = file.actions
    assert literal(node.name).span.text == "chat"
    assert isinstance(node.parameters[0], DictValue)
    assert [item.value for item in node.parameters[0].items[0][1].items] == [1, 2]


@pytest.mark.parametrize(
    "text", ["", "<launch>", "<launch><node/></launch>", "<robot/>", "<launch><a><b/></a></launch>"]
)
def test_odd_xml_is_read(text: str) -> None:
    check_spans(launch_xml.parse(Source("x.launch.xml", text)))


TAGS = st.sampled_from("node arg group include let param remap timer executable env launch set_env".split())
PIECES = st.sampled_from(
    ["$(var ", "$(", ")", "'", '"', "\\", " ", "x", "$", "eval ", "find-pkg-share ", "é", "&amp;", "/"]
)
TEXTS = st.lists(PIECES, max_size=14).map("".join)


@given(TEXTS)
def test_no_substitution_makes_it_raise(text: str) -> None:
    found = value(text)
    assert found.span.end <= len(text)


@given(st.lists(st.tuples(TAGS, TEXTS), max_size=8))
def test_no_xml_makes_it_raise(tags: list[tuple[str, str]]) -> None:
    body = "".join(f"<{tag} name='{text}' value=\"{text}\" if='{text}'>" for tag, text in tags)
    check_spans(launch_xml.parse(Source("x.launch.xml", f"<launch>{body}</launch>")))


@given(st.lists(st.tuples(TAGS, TEXTS), max_size=8))
def test_no_yaml_makes_it_raise(tags: list[tuple[str, str]]) -> None:
    body = "".join(f"- {tag}:\n    name: {text}\n    param: [{text}, {{a: {text}}}]\n" for tag, text in tags)
    check_spans(launch_yaml.parse(Source("x.launch.yaml", f"launch:\n{body}")))
