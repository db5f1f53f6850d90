"""Classes of C++ that nothing makes, and those that something does."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot
from bringup_lint.source import Source

HEADER = """\
#ifndef WEIR_HPP
#define WEIR_HPP
class Gate;
class Weir final : public Base
{
public:
  explicit Weir(int level);
  ~Weir();
  void open();
};
#endif
"""
SOURCE = """\
#include "weir.hpp"
// a Weir is made nowhere
Weir::Weir(int level) : Base(level) {
}
void Weir::open() {
  lock();  // here
}
"""
TREE = {
    "include/weir.hpp": HEADER,
    "src/weir.cpp": SOURCE,
    "src/otter.cpp": "int main() { return 0; }\n",
    "package.xml": "<package><name>otter</name></package>",
}


def leads_to(folder: Path, files: dict[str, str], name: str, word: str) -> bool:
    for each, text in files.items():
        path = folder / each
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    robot = Robot(discover([str(folder)]))
    source = Source(os.fspath(folder / name), (folder / name).read_text())
    start = source.text.index(word)
    return robot.leads_to(source.span(start, start + 1))


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({}, False),
        ({"src/other.cpp": "class Weir;\n#include <weir.hpp>\n"}, False),
        ({"src/main.cpp": "int main() { Weir weir(4); }\n"}, True),
        ({"include/weir.hpp": HEADER + "class Lock : public Weir {\n};\n"}, True),
        ({"src/weir.cpp": SOURCE + "int main() {\n  Weir::run();\n}\n"}, True),
        ({"src/weir.cpp": SOURCE + "int main() {\n  return Weir::run();\n}\n"}, True),
        ({"src/weir.cpp": SOURCE + "int Weir::run() {\n  return 0;\n}\n"}, False),
        ({"src/weir.cpp": SOURCE + "RCLCPP_COMPONENTS_REGISTER_NODE(otter::Weir)\n"}, True),
        ({"src/weir.cpp": SOURCE + "int main() { std::make_shared<Weir>(4); }\n"}, True),
        ({"src/weir.cpp": SOURCE + "int main() { auto * weir = new otter::Weir(4); }\n"}, True),
        ({"src/weir.cpp": SOURCE + "int main() { auto weir = Weir{4}; }\n"}, True),
        ({"src/weir.cpp": SOURCE + "Base weir() { return Weir(4); }\n"}, True),
        ({"src/otter.cpp": "int otter();\n"}, True),
        ({"plugins.xml": "<class type='otter::Weir'/>\n"}, True),
        ({"a.launch.py": "ComposableNode(plugin='otter::Weir')\n"}, True),
    ],
)
@pytest.mark.parametrize(("name", "word"), [("src/weir.cpp", "lock"), ("include/weir.hpp", "void open")])
def test_a_class_is_used_where_its_name_is(
    tmp_path: Path, files: dict[str, str], expected: bool, name: str, word: str
) -> None:
    assert leads_to(tmp_path, {**TREE, **files}, name, word) is expected


def test_code_outside_of_classes_counts_as_used(tmp_path: Path) -> None:
    assert leads_to(tmp_path, {"a.cpp": "int a();\n"}, "a.cpp", "a()")
    assert leads_to(tmp_path, {"a.cpp": SOURCE}, "a.cpp", "lock")
    assert leads_to(tmp_path, {"a.cpp": SOURCE + "int after();\n"}, "a.cpp", "after")


def test_what_only_tests_make_is_on_no_robot(tmp_path: Path) -> None:
    package = {"package.xml": "<package><name>weir</name></package>"}
    maker = '#include "weir.hpp"\nclass Fake : public Weir {};\n'
    assert not leads_to(tmp_path / "one", {**TREE, **package, "tests/fake.cpp": maker}, "src/weir.cpp", "lock")
    assert leads_to(tmp_path / "two", {**TREE, **package, "fakes/fake.cpp": maker}, "src/weir.cpp", "lock")


def test_a_tree_of_very_many_files_is_not_looked_through(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bringup_lint.graph.unmade._MOST", 1)
    assert leads_to(tmp_path, TREE, "src/weir.cpp", "lock")


def test_what_the_configuration_calls_the_robots_is_used(tmp_path: Path) -> None:
    for name, text in TREE.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    purposes = {os.fspath(tmp_path / "src"): "robot"}
    robot = Robot(discover([str(tmp_path)]), purposes=purposes)
    source = robot.tree.read(os.fspath(tmp_path / "src/weir.cpp"), judged=False)
    assert source is not None
    assert robot.leads_to(source.span(source.text.index("lock"), source.text.index("lock") + 1))
