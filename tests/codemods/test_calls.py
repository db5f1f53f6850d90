"""Arguments of calls are added and removed in the style of the call, and every other byte stays."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from bringup_lint.codemods.calls import all_of
from bringup_lint.codemods.calls import in_call
from bringup_lint.codemods.calls import in_list
from bringup_lint.codemods.calls import renamed_keyword
from bringup_lint.codemods.calls import with_item
from bringup_lint.codemods.calls import with_items
from bringup_lint.codemods.calls import with_keyword
from bringup_lint.codemods.calls import without_keyword
from bringup_lint.codemods.imports import Import
from bringup_lint.codemods.statements import wait_in_loop
from bringup_lint.finding import Codemod
from bringup_lint.source import Source
from bringup_lint.source import Span

SHUTDOWN = Import("launch.actions", "Shutdown")


def change(text: str, place: str, make: Callable[..., Codemod | None], *words: object) -> str:
    source = Source("robot.launch.py", text)
    codemod = make(Span(source, text.index(place), text.index(place) + len(place)), *words)
    return codemod.change(text) if codemod else "no"


@pytest.mark.parametrize(
    ("call", "after"),
    [
        ("Node()", "Node(on_exit=x)"),
        ("Node(a)", "Node(a, on_exit=x)"),
        ("Node(a, b=1,)", "Node(a, b=1, on_exit=x,)"),
        ("Node(a,\n     b=1)", "Node(a,\n     b=1,\n     on_exit=x)"),
        ("Node(\n    a,  # é\n    b=1  # last\n)", "Node(\n    a,  # é\n    b=1,  # last\n    on_exit=x\n)"),
        ("Node(\n    a,\n    # why\n    b=1,\n)", "Node(\n    a,\n    # why\n    b=1,\n    on_exit=x,\n)"),
        ("Node(\n    a  # only\n)", "Node(\n    a,  # only\n    on_exit=x\n)"),
        ("Node(a=1  # one\n)", "Node(a=1,  # one\non_exit=x\n)"),
        ("Node(**more)", "no"),
        ("Node(on_exit=y)", "no"),
        ("node", "no"),
    ],
)
def test_keyword_is_added(call: str, after: str) -> None:
    text = change(f"é = [{call}]\n", call, with_keyword, "on_exit", "x")
    assert text == ("no" if after == "no" else f"é = [{after}]\n")


def test_imports_are_added_once() -> None:
    before = "from launch.actions import Shutdown\nNode()\n"
    assert change(before, "Node()", with_keyword, "on_exit", "Shutdown()", SHUTDOWN) == (
        "from launch.actions import Shutdown\nNode(on_exit=Shutdown())\n"
    )
    assert change('"""Doc."""\nimport os\nNode()\n', "Node()", with_keyword, "on_exit", "Shutdown()", SHUTDOWN) == (
        '"""Doc."""\nimport os\nfrom launch.actions import Shutdown\n\nNode(on_exit=Shutdown())\n'
    )


@pytest.mark.parametrize(
    ("call", "after"),
    [
        ("Node()", "Node(names=[1])"),
        ("Node(names=[])", "Node(names=[1])"),
        ("Node(names=[0])", "Node(names=[0, 1])"),
        ("Node(names=[\n  0,\n])", "Node(names=[\n  0,\n  1,\n])"),
        ("Node(names=[\n  0  # zero\n])", "Node(names=[\n  0,  # zero\n  1\n])"),
        ("Node(names=more)", "no"),
        ("Node(**more)", "no"),
    ],
)
def test_list_gets_an_element(call: str, after: str) -> None:
    assert change(f"{call}\n", call, with_item, "names", "1") == ("no" if after == "no" else f"{after}\n")


def test_list_gets_several_elements() -> None:
    assert change("f(Node(a=[0]), 'é')\n", "Node(a=[0])", with_items, "a", "1", "2") == "f(Node(a=[0, 1, 2]), 'é')\n"
    assert change("f(Node(), 'é')\n", "Node()", with_items, "a", "1", "2") == "f(Node(a=[1, 2]), 'é')\n"
    assert change("f(Node(a=b), 'é')\n", "Node(a=b)", with_items, "a", "1", "2") == "no"


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("f(a, b='x')", "f(a)"),
        ("f(b='x')", "f()"),
        ("f(\n    b='x',\n    c=1,\n)", "f(\n    c=1,\n)"),
        ("f(\n    c=1,\n    b='x',\n)", "f(\n    c=1,\n)"),
        ("f(a, 'x')", "f(a, 'x')"),
    ],
)
def test_keyword_is_removed(before: str, after: str) -> None:
    assert change(f"{before}\n", "'x'", without_keyword) == f"{after}\n"


def test_keyword_gets_another_name() -> None:
    assert change("f(a, b = 1)\n", "f(a, b = 1)", renamed_keyword, "b", "c") == "f(a, c = 1)\n"
    assert change("f(a, b=1, c=2)\n", "f(a, b=1, c=2)", renamed_keyword, "b", "c") == "no"
    assert change("f(a)\n", "f(a)", renamed_keyword, "b", "c") == "no"


def test_expression_is_wrapped() -> None:
    text = "from launch.actions import Shutdown\nx = [\n    f(\n        a\n    ),  # why\n]\n"
    assert change(text, "f(\n        a\n    )", in_list) == text.replace("f(", "[f(").replace("),", ")],")
    grouped = change(text, "f(\n        a\n    )", in_call, Import("launch.actions", "GroupAction"))
    assert grouped.partition("\n")[0] == "from launch.actions import GroupAction, Shutdown"
    assert grouped.partition("\n")[2] == "x = [\n    GroupAction([f(\n        a\n    )]),  # why\n]\n"


def test_several_changes_are_one() -> None:
    text = "[f(), g()]\n"
    source = Source("robot.launch.py", text)
    places = [Span(source, 1, 4), Span(source, 6, 9)]
    codemod = all_of(*(with_keyword(place, "a", "1") for place in places))
    assert codemod is not None and codemod.change(text) == "[f(a=1), g(a=1)]\n"
    assert all_of(with_keyword(places[0], "a", "1"), None) is None


def test_wait_becomes_a_loop() -> None:
    before = "class A:\n  def f(self):\n    # arm\n    self.arm.wait_for_service()  # long\n    go()\n"
    assert change(before, "self.arm.wait_for_service()", wait_in_loop, "Waiting for it") == (
        "class A:\n  def f(self):\n    # arm\n"
        "    while self.context.ok() and not self.arm.wait_for_service(timeout_sec=1.0):  # long\n"
        "      self.get_logger().info('Waiting for it')\n    go()\n"
    )
    for text in ("x = self.arm.wait_for_service()\n", "arm.wait_for_service()\n"):
        call = text.removeprefix("x = ").strip()
        assert change(text, call, wait_in_loop, "Waiting for it") == "no"


def test_other_files_than_python_are_left_alone() -> None:
    source = Source("robot.launch.xml", "f()")
    assert with_keyword(Span(source, 0, 3), "a", "1") is None
    assert without_keyword(Span(source, 0, 3)) is None
