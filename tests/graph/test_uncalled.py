"""Python code that never runs, and code that may."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot
from bringup_lint.source import Source

NODE = """\
import rclpy
from rclpy.node import Node

class Weir(Node):
    def __init__(self):
        super().__init__("weir")
        self.open()

    def open(self):
        pass

    def lower_gate(self, slowly=False):
        self.level = 0  # here

def main():
    rclpy.init()
    rclpy.spin(Weir())
"""
CALLED = NODE.replace("        pass\n", "        self.lower_gate()\n")


def branch(test: str, *, head: str = "", made: str = "", call: str = "self.lower_gate()") -> str:
    """A node with a branch in the called function."""
    return head + CALLED.replace("        self.level = 0", f"        if {test}:\n            self.level = 0").replace(
        "        self.open()\n", f"        self.open()\n        {made}\n"
    ).replace("self.lower_gate()", call)


def leads_to(folder: Path, node: str, files: dict[str, str], word: str = "here") -> bool:
    for each, text in ({"weir.py": node} | files).items():
        path = folder / each
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    robot = Robot(discover([str(folder)]))
    source = Source(os.fspath(folder / "weir.py"), node)
    start = source.text.index(word)
    return robot.leads_to(source.span(start, start + 1))


def notebook(*cells: str) -> str:
    return json.dumps({"cells": [{"cell_type": "code", "source": [each]} for each in cells]})


@pytest.mark.parametrize(
    "files",
    [
        {},
        {"otter.py": "import weir\n"},
        {"otter.py": "class Otter:\n    def lower_gate(self):\n        self.lower_gate()\n"},
        {"otter.py": 'def dive():\n    """Like lower_gate."""\n'},
        {"otter.py": "def dive(weir):\n    weir.lower_gate()\n"},
        {"otter.py": "def main(logging, msg, name):\n    getattr(logging, name)\n    getattr(msg, 'data', None)\n"},
        {"otter": "no program: lower_gate\n"},
        {"otter.ipynb": "no notebook: lower_gate"},
        {"otter.ipynb": notebook("def (", "lower_gates()\n%time lower_gate\n")},
        {"otter.cpp": "void Otter::lower_gate() { rclcpp::spin(node); }\n"},
    ],
)
def test_a_method_that_nothing_calls(tmp_path: Path, files: dict[str, str]) -> None:
    assert not leads_to(tmp_path, NODE, files)


@pytest.mark.parametrize(
    "files",
    [
        {"otter.py": "from weir import Weir\nWeir().lower_gate()\n"},
        {"otter.py": "def main(weir):\n    weir.lower_gate()\n"},
        {"otter.py": "def main(weir):\n    getattr(weir, 'lower_gate')()\n"},
        {"otter.py": "from weir import lower_gate as low\n"},
        {"otter.py": "def dive(:\n    lower_gate()\n"},
        {"otter.py": 'print(f"{otter["name"]}")\nlower_gate()\n', "beaver.py": "def dive(:\n    lower_gate()\n"},
        {"otter.py": "def main(weir, name):\n    getattr(weir, name)()\n"},
        {"otter.py": "def main(weir, name):\n    getattr(find(weir), 'lower_' + name)()\n"},
        {"otter.py": "class Otter(Weir):\n    def do(self, name):\n        getattr(self, name)()\n"},
        {"otter.py": "import fire, weir\nfire.Fire(weir.Weir)\n"},
        {"otter.py": "def main(weir, name):\n    eval(f'weir.{name}()')\n"},
        {"otter": "#!/usr/bin/env python3\nimport weir\nweir.Weir().lower_gate()\n"},
        {"otter.in": "#!@PYTHON@\nimport weir\nweir.Weir().lower_gate()\n".replace("@PYTHON@", "/usr/bin/python3")},
        {"otter.urdf": "<robot name='otter'><plugin type='weir.Weir'/></robot>\n"},
        {"pyproject.toml": "[project.scripts]\nweir = 'weir:lower_gate'\n"},
        {"Dockerfile": "FROM ros:jazzy\nCMD python3 -c 'import weir; weir.Weir().lower_gate()'\n"},
        {"otter.py": "def main(weir):\n    pass\n    # weir.lower_gate()\n"},
        {"otter.py": "def main(weir):\n    match weir:\n        case 1:\n            weir.lower_gate()\n"},
        {"otter.ipynb": notebook("import weir", "weir.Weir().lower_gate()")},
        {"otter.launch.yaml": "launch:\n- executable: {cmd: python3 -c 'lower_gate'}\n"},
    ],
)
def test_a_method_that_something_may_call(tmp_path: Path, files: dict[str, str]) -> None:
    assert leads_to(tmp_path, NODE, files)


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("    def lower_gate", "    @property\n    def lower_gate", False),
        ("    def lower_gate", "    @app.route('/')\n    def lower_gate", True),
        ("lower_gate(", "on_gate(", False),
        ("lower_gate(", "paintEvent(", True),
        ("Weir(Node)", "Weir(Widget)", True),
        ("Weir(Node)", "Weir(Node, metaclass=Gate)", True),
        ("Weir(Node)", "Weir(make())", True),
        ("        pass\n", "        lower_gate()\n", False),
        ("        pass\n", "        getattr(self.pump, self.what)()\n", True),
        ("    def open", "    lower = [lower_gate]\n\n    def open", True),
        ("class Weir(Node)", "class Base:\n    pass\n\nclass Weir(Base)", False),
        ("class Weir(Node)", "@dataclass(eq=False)\nclass Weir(Node)", False),
        ("class Weir(Node)", "@expose\nclass Weir(Node)", True),
        ("class Weir(Node)", "class Base(Other):\n    pass\n\nclass Weir(Base)", True),
        ("        pass\n", "        getattr(self, f'lower_{self.what}')()\n", True),
        (
            "class Weir(Node)",
            "class Base(Node):\n    def do(self):\n        getattr(self, self.x)()\n\nclass Weir(Base)",
            True,
        ),
        ("        pass\n", "        def lower_gate():\n            lower_gate()\n", False),
        ("def main", "def start", True),
        ("slowly=False):\n", "slowly=False): return here\n", True),
        ("        pass\n", "        self.lower_gate()\n", True),
        (
            "        pass\n",
            "        try:\n            pass\n        except OSError:\n            self.lower_gate()\n",
            True,
        ),
        ("        pass\n", "        self.timer = self.create_timer(1.0, self.lower_gate)\n", True),
    ],
)
def test_what_a_method_is(tmp_path: Path, old: str, new: str, *, expected: bool) -> None:
    assert leads_to(tmp_path, NODE.replace(old, new, 1), {}) is expected


OTHER = """\
class Otter(Weir):
    def lower_gate(self):
        pass

    def dive(self):
        self.lower_gate()

Otter().dive()
"""


def test_a_transition_of_a_lifecycle_node_is_run_by_its_name(tmp_path: Path) -> None:
    for old, new in (("Weir(Node)", "Weir(LifecycleNode)"), ("class Weir(Node)", "class Weir")):
        assert leads_to(tmp_path, NODE.replace("lower_gate(", "on_configure(").replace(old, new), {})
    function = NODE.replace("    def lower_gate(self, slowly=False):\n        self", "def on_gate():\n    self")
    assert leads_to(tmp_path, function, {})


def test_a_private_method_is_not_reached_by_a_computed_name(tmp_path: Path) -> None:
    reaching = {"otter.py": "def main(weir, name):\n    getattr(weir, name)()\n"}
    assert leads_to(tmp_path, NODE, reaching)
    assert not leads_to(tmp_path, NODE.replace("lower_gate", "_lower_gate"), reaching)


BASE = """\
class Base(Node):
    def dive(self):
        self.other = 1

class Other(Base):
    def close(self):
        self.lower_gate()

    def lower_gate(self):
        self.fast = True

def close():
    Other().close()

close()
"""


def test_a_class_may_build_on_one_of_the_tree(tmp_path: Path) -> None:
    node = NODE.replace("Weir(Node)", "Weir(Base)")
    assert not leads_to(tmp_path, node, {"base.py": BASE})
    assert leads_to(tmp_path, node.replace("Weir(Base)", "Weir(Other)"), {"base.py": BASE})


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("", "", False),
        ("self.other = 1", "self.fast = False", False),
        ("self.other = 1", "self.fast = True", True),
        ("    def dive", "    fast = True\n\n    def dive", True),
        ("    def dive", "    def fast(self):\n        return 1\n\n    def dive", True),
        ("self.other = 1", "self.__dict__.update(fast=1)", True),
        ("self.other = 1", "setattr(weir, 'f' + name, 1)", True),
        ("self.other = 1", "getattr(weir, 'f' + name)", True),
    ],
)
def test_what_a_base_sets(tmp_path: Path, old: str, new: str, *, expected: bool) -> None:
    text = branch("self.fast", made="self.fast = False").replace("class Weir(Node)", "class Weir(Base)")
    assert leads_to(tmp_path, text, {"base.py": BASE.replace(old, new, 1)}) is expected


def test_a_computed_name_elsewhere_only_reads_attributes(tmp_path: Path) -> None:
    text = branch("self.fast", made="self.fast = False")
    assert not leads_to(tmp_path, text, {"otter.py": "def go(weir, key):\n    getattr(weir, key)\n"})


def test_a_method_of_another_that_has_the_name_is_another(tmp_path: Path) -> None:
    assert not leads_to(tmp_path, NODE, {"otter.py": OTHER})
    assert leads_to(tmp_path, NODE.replace("Weir(Node)", "Weir(Otter)"), {"otter.py": OTHER.replace("(Weir)", "")})


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (branch("slowly"), False),
        (branch("not slowly"), True),
        (branch("not (slowly or False)"), True),
        (branch("slowly and self.get()"), False),
        (branch("slowly or self.get()"), True),
        (branch("1 or self.get()"), True),
        (branch("self.get()"), True),
        (branch("rclpy.ok()"), True),
        (branch("slowly", call="self.lower_gate(True)"), True),
        (branch("slowly", call="self.lower_gate(slowly=True)"), True),
        (branch("slowly", call="self.lower_gate(slowly=False)"), False),
        (branch("slowly", call="self.lower_gate(*self.arguments)"), True),
        (branch("slowly", call="self.lower_gate(**self.arguments)"), True),
        (branch("slowly", call="self.create_timer(1.0, self.lower_gate)"), True),
        (branch("slowly").replace("slowly=False)", "slowly=3 * 0)"), True),
        (branch("slowly").replace("slowly=False)", "*, slowly=False)"), False),
        (branch("slowly").replace("slowly=False)", "slowly=False, **rest)"), True),
        (branch("slowly").replace("        if slowly", "        slowly = self.get()\n        if slowly"), True),
        (branch("self.fast", made="self.fast = False"), False),
        (branch("self.fast", made="self.fast: bool = False"), False),
        (branch("self.fast", made="self.fast = self.fast = True"), True),
        (branch("self.fast", made="self.fast = self.get()"), True),
        (branch("self.fast", made="self.fast, self.slow = False, True"), True),
        (branch("self.fast", made="self.fast = False\n        setattr(self, key, 1)"), True),
        (branch("self.fast", made="self.fast = False").replace("class Weir(Node)", "class Weir(Base)"), True),
        (branch("self.fast", made="self.fast = False") + "\nclass Otter(Weir):\n    pass\n", True),
        (branch("self.fast", made="self.fast = False") + "\ndef start(weir):\n    weir.fast = True\n", True),
        (branch("FAST", head="FAST = False\n"), False),
        (branch("FAST", head="FAST = OTHER\n"), True),
        (branch("FAST", head="FAST = False\nFAST = True\n"), True),
        (branch("FAST", head="from otter import FAST\n"), True),
        (branch("FAST", head="FAST = False\n") + "\ndef start():\n    global FAST\n    FAST = True\n", True),
        (branch("FAST", head="FAST = False\n") + "\ndef start(weir):\n    weir.FAST = True\n", True),
        (branch("FAST", head="FAST = False\nfrom otter.msg import *\n"), False),
        (branch("FAST", head="from otter import *\nFAST = False\n"), False),
        (branch("FAST", head="def f():\n    from otter import FAST\nFAST = False\n"), True),
        (branch("FAST", head="FAST = False\nfrom otter import *\n"), True),
        (branch("FAST", head="FAST = False\nfrom otter import quick as FAST\n"), True),
        (branch("FAST", head="FAST = False\nfrom otter import FAST\n"), True),
        (branch("FAST", head="FAST = False\nglobals().update(FAST=True)\n"), True),
        (branch("FAST", head="FAST = False\n") + "\ndef start(weir):\n    setattr(weir, 'FAST', True)\n", True),
        (branch("self.fast", made="self.fast = False") + "\ndef go(weir):\n    setattr(weir, 'fast', 1)\n", True),
        (branch("self.fast", made="self.fast = False") + "\ndef go(weir, key):\n    setattr(weir, key, 1)\n", True),
        (
            branch("self.fast", made="self.fast = False").replace(
                "    def open", "    @property\n    def fast(self):\n        return self.level > 3\n\n    def open"
            ),
            True,
        ),
        (branch("slowly").replace("    def lower_gate", "    @app.get('/')\n    def lower_gate"), True),
        (branch("slowly", call="self.get()").replace("lower_gate", "execute"), True),
        (branch("self.get():\n            pass\n        elif slowly"), False),
        (branch("not slowly:\n            pass\n        else"), False),
        (branch("slowly:\n            pass\n        else"), True),
        (branch("a").replace("if a:\n            self.level = 0", "if slowly: self.level = 0"), True),
    ],
)
def test_branches(tmp_path: Path, text: str, *, expected: bool) -> None:
    assert leads_to(tmp_path, text, {}) is expected


def test_an_argument_of_a_class_is_given_where_it_is_made(tmp_path: Path) -> None:
    text = branch("self.fast", made="self.fast = fast").replace("__init__(self)", "__init__(self, fast=False)")
    assert not leads_to(tmp_path, text, {})
    assert leads_to(tmp_path, text.replace("Weir())", "Weir(True))"), {})
    assert leads_to(tmp_path, f"{text}\ndef quick(cls):\n    return cls(True)\n", {})
    assert leads_to(tmp_path, text, {"otter.py": "from weir import Weir as Dam\n"})


def test_an_attribute_of_a_class_may_be_set_by_one_that_builds_on_it(tmp_path: Path) -> None:
    text = branch("self.fast", made="self.fast = False")
    assert leads_to(tmp_path, text, {"otter.py": "from weir import Weir as Dam\n\nclass Otter(Dam):\n    pass\n"})


def test_an_argument_handed_on_for_ever_is_unknown(tmp_path: Path) -> None:
    text = branch("slowly") + "\ndef lower(weir, slowly=False):\n    weir.lower_gate(slowly)\n    lower(weir, slowly)\n"
    assert leads_to(tmp_path, text, {})


def test_a_static_method_has_no_self(tmp_path: Path) -> None:
    text = branch("slowly").replace(
        "    def lower_gate(self, slowly=False)", "    @staticmethod\n    def lower_gate(slowly=False)"
    )
    assert not leads_to(tmp_path, text, {})


def test_code_that_python_refuses(tmp_path: Path) -> None:
    assert leads_to(tmp_path, f"{NODE}\ndef (", {})


def test_code_too_deep(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: str) -> None:
        raise RecursionError

    monkeypatch.setattr("bringup_lint.graph.uncalled.code.ast.parse", refuse)
    assert leads_to(tmp_path, NODE, {})


def test_a_text_that_is_no_python(tmp_path: Path) -> None:
    (tmp_path / "weir.py").write_text(NODE)
    robot = Robot(discover([str(tmp_path)]))
    source = Source(os.fspath(tmp_path / "weir.txt"), NODE)
    assert robot.leads_to(source.span(NODE.index("here"), NODE.index("here") + 1))


@pytest.mark.parametrize("limit", ["_MOST", "_FILES"])
def test_too_many_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, limit: str) -> None:
    monkeypatch.setattr(f"bringup_lint.graph.uncalled.code.{limit}", 0)
    assert leads_to(tmp_path, NODE, {})
    assert leads_to(tmp_path, branch("slowly"), {})
