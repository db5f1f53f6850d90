"""What nodes import from other modules of the tree: names, profiles and defaults."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from bringup_lint.graph.nodes.sources.modules import STEPS
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from tests.conftest import PROJECT
from tests.graph.nodes.test_nodes import python_package
from tests.graph.nodes.test_nodes import robot
from tests.lint import lint

NODE = """from rclpy.node import Node
from sensor_msgs.msg import LaserScan
{imports}

class Arm(Node):
    def __init__(self):
        super().__init__("arm")
        self.create_publisher(LaserScan, {name}, {qos})
"""


def of(top: Path, imports: str, name: str, qos: str = "10", **modules: str) -> NodeClass:
    """The node of a package with some modules."""
    node = NODE.format(imports=imports, name=name, qos=qos)
    found = robot(top, python_package("'run = arm.node:main'", node=node, **modules))
    return next(each for file in found.nodes.judged for each in file.classes if each.name == "Arm")


def endpoint(top: Path, imports: str, name: str, qos: str = "10", **modules: str) -> Endpoint:
    return of(top, imports, name, qos, **modules).endpoints[0]


@pytest.mark.parametrize(
    ("imports", "name"),
    [
        ("from .names import SCAN", "SCAN"),
        ("from .names import SCAN as S", "S"),
        ("from . import names", "names.SCAN"),
        ("from arm import names", "names.SCAN"),
        ("from arm.names import SCAN", "SCAN"),
        ("import arm.names", "arm.names.SCAN"),
        ("import arm.names as n", "n.SCAN"),
        ("import names", "names.SCAN"),
        ("from .names import *", "SCAN"),
        ("from . import *\nfrom rclpy.qos import *", "PACKAGE"),
        ("from .names import *", "Topics.SCAN"),
        ("from .names import Topics", "Topics.SCAN"),
        ("from .names import Keys", "Keys.SCAN.value"),
        ("from .names import Keys", "Keys.scan.name"),
        ("from .names import PREFIX", "PREFIX + 'an'"),
        ("from .names import AGAIN", "AGAIN"),
        ("from .names import LISTED", "LISTED"),
    ],
)
def test_a_name_of_another_module(tmp_path: Path, imports: str, name: str) -> None:
    names = (
        "from enum import Enum\nfrom .deeper import SCAN as AGAIN\nfrom .deeper import *\n"
        "SCAN = 'scan'\nPREFIX = 'sc'\n"
        "class Topics:\n    SCAN = 'scan'\n"
        "class Keys(Enum):\n    SCAN = 'scan'\n    scan = 1\n"
    )
    modules = {"names": names, "deeper": "SCAN = 'scan'\nLISTED = f'{SCAN}'\n", "__init__": "PACKAGE = 'scan'\n"}
    assert endpoint(tmp_path, imports, name, **modules).name == "scan"


@pytest.mark.parametrize(
    ("imports", "name", "module"),
    [
        ("from .names import SCAN", "SCAN", "SCAN = 'a'\nSCAN = 'b'\n"),
        ("from .names import SCAN", "SCAN", "import os\nSCAN = os.environ['SCAN']\n"),
        ("from .names import SCAN", "SCAN", "from .node import OTHER as SCAN\n"),
        ("from .names import SCAN", "SCAN", "from .names import SCAN\n"),
        ("from .names import SCAN", "SCAN", "from .gone import SCAN\n"),
        ("from .names import SCAN", "SCAN", "def SCAN():\n    pass\n"),
        ("from .names import Topics", "Topics", "class Topics:\n    SCAN = 'scan'\n"),
        ("from .names import Topics", "Topics.SCAN", "class Topics:\n    SCAN = 'scan'\nTopics.SCAN = 'other'\n"),
        ("from .names import A", "A.B.SCAN", "class A:\n    class B:\n        SCAN = 'scan'\n"),
        ("from .names import Keys", "Keys.SCAN", "from enum import Enum\nclass Keys(Enum):\n    SCAN = 'scan'\n"),
        ("from .names import Keys", "Keys.SCAN.value", "from enum import Enum\nclass Keys(Enum):\n    SCAN = auto()\n"),
        ("from .names import Keys", "Keys.NONE.name", "from enum import Enum\nclass Keys(Enum):\n    SCAN = 'scan'\n"),
        ("from .names import *", "_SCAN", "_SCAN = 'scan'\n"),
        ("from .names import *\nfrom .second import *", "SCAN", "SCAN = 'scan'\n"),
        ("from . import names\nnames.SCAN = 'other'", "names.SCAN", "SCAN = 'scan'\n"),
        ("from .names import SCAN", "SCAN", "SCAN = ("),
        ("from .names import node", "node.get_parameter('scan').value", "node = None\n"),
        ("from .names import SCAN", "SCAN", "SCAN = node.get_parameter('scan').value\n"),
        ("from .names import *", "[each for each in SCAN][0]", "SCAN = 'scan'\n"),
    ],
)
def test_a_name_that_is_not_known(tmp_path: Path, imports: str, name: str, module: str) -> None:
    assert endpoint(tmp_path, imports, name, names=module, second="SCAN = 'other'\n").name is None


def test_the_place_of_a_name_is_in_its_module(tmp_path: Path) -> None:
    found = endpoint(tmp_path, "from .names import SCAN", "SCAN", names="SCAN = 'scan'\n")
    assert found.name is not None
    assert (found.name.path.rpartition("/")[2], found.name.line, found.name.span.text) == ("names.py", 1, "scan")
    assert found.name.span.source.judged


def test_a_type_that_another_module_hands_on(tmp_path: Path) -> None:
    node = NODE.replace("LaserScan, {name}", "Scan, {name}")
    text = node.format(imports="from .types import Scan", name="'s'", qos=1)
    files = python_package("'run = arm.node:main'", node=text)
    files["arm/arm/types.py"] = "from sensor_msgs.msg import LaserScan as Scan\n"
    (file,) = robot(tmp_path, files).nodes.judged
    assert file.classes[0].endpoints[0].type == "sensor_msgs/msg/LaserScan"


@pytest.mark.parametrize(
    ("module", "expected"),
    [
        ("DEEP = 3\nQOS = QoSProfile(depth=DEEP, reliability=ReliabilityPolicy.BEST_EFFORT)\n", ("BEST_EFFORT", 3)),
        ("QOS = qos_profile_sensor_data\n", ("BEST_EFFORT", 5)),
        ("QOS = 7\n", ("RELIABLE", 7)),
        ("QOS = QoSProfile(depth=1, deadline=Duration(seconds=2))\n", ("RELIABLE", 1)),
        ("QOS = QoSProfile(depth=1)\nQOS.depth = 4\n", None),
        ("QOS = made(1)\n", None),
        ("class Profile:\n    pass\nQOS = Profile()\n", None),
    ],
)
def test_a_profile_of_another_module(tmp_path: Path, module: str, expected: tuple[str, int] | None) -> None:
    imports = "from rclpy.qos import *\nfrom rclpy.duration import Duration\n".replace(
        "*", "QoSProfile, ReliabilityPolicy, qos_profile_sensor_data"
    )
    found = endpoint(tmp_path, "from .profiles import QOS", "'scan'", "QOS", profiles=imports + module).qos
    assert (found and (found.reliability, found.depth)) == expected
    if "deadline" in module:
        assert found is not None and found.deadline == 2
    if "DEEP" in module:
        assert found is not None and found.span.path.endswith("profiles.py")


def test_a_default_of_another_module(tmp_path: Path) -> None:
    node = of(
        tmp_path,
        "from .names import RATE, NAME",
        "self.declare_parameter(NAME, RATE).value",
        names="RATE = 2.5\nNAME = 'rate'\n",
    )
    assert node.parameters["rate"].default == 2.5


def test_a_long_line_of_modules_ends(tmp_path: Path) -> None:
    modules = {f"m{number}": f"from .m{number + 1} import SCAN\n" for number in range(4 * STEPS)}
    modules[f"m{4 * STEPS}"] = "SCAN = 'scan'\n"
    assert endpoint(tmp_path, "from .m0 import SCAN", "SCAN", **modules).name is None


def test_nothing_is_read_that_no_node_asks_for(tmp_path: Path) -> None:
    files = python_package("'run = arm.node:main'", names="SCAN = 'scan'\n", unused="SCAN = 'scan'\n")
    files["arm/arm/node.py"] = NODE.format(imports="from .names import SCAN\nfrom . import unused", name="SCAN", qos=1)
    found = robot(tmp_path, files)
    (file,) = found.nodes.judged
    assert file.classes[0].endpoints[0].name == "scan"
    read = {each.rpartition("/")[2] for each in found.tree._by_reference}
    assert "names.py" in read and "unused.py" not in read


def test_the_syntax_goes_when_nobody_asks_for_it(tmp_path: Path) -> None:
    files = python_package("'run = arm.node:main'", names="SCAN = 'scan'\n")
    files["arm/arm/node.py"] = NODE.format(imports="from .names import SCAN", name="SCAN", qos=1)
    found = robot(tmp_path, files)
    (file,) = found.nodes.judged
    found.let_go_of_syntax()
    assert file.tree is None and file.constant(file.source) is None
    (again,) = found.nodes.judged
    assert again.classes[0].endpoints[0].name == "scan"


def test_a_name_is_corrected_where_it_is_written_and_no_f_string_is(tmp_path: Path) -> None:
    shutil.copytree(PROJECT / "fixtures/node/topic_name_invalid/bad_modules", tmp_path, dirs_exist_ok=True)
    lint("--select", "node/topic-name-invalid", "--fix", "--unsafe-fixes", ".", cwd=tmp_path)
    text = (tmp_path / "mower/mower/topics.py").read_text()
    assert 'IMAGE = "camera_1/image"' in text and 'INFO = f"{PREFIX}/camera_info"' in text
