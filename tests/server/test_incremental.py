"""A run that shares sources with the one before finds what a run from nothing finds, after any edits."""

from __future__ import annotations

import random
import shutil
from pathlib import Path

import pytest

from bringup_lint.registry import Registry
from bringup_lint.server.analysis import Document
from bringup_lint.server.analysis import uri_of
from bringup_lint.server.folder import Folder
from bringup_lint.server.folder import State
from tests.conftest import PROJECT

ROBOTS = PROJECT / "fixtures/robots"
EDITS = 6


@pytest.fixture
def top(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of a robot, to be edited."""
    top = tmp_path / "robot"
    shutil.copytree(ROBOTS / request.param / "tree", top, symlinks=True)
    monkeypatch.chdir(top)
    return top


def edited(text: str, chance: random.Random) -> str:
    """The text without a line, with one twice, or with a character in front of one."""
    lines = text.splitlines(keepends=True)
    at = chance.randrange(len(lines))
    lines[at : at + 1] = chance.choice(([], [lines[at]] * 2, ["#" + lines[at]], [lines[at].upper()]))
    return "".join(lines)


def answer(folder: Folder, documents: dict[str, Document]) -> list[str]:
    folder.change()
    analysis = folder.check(State(folder.generation, documents))
    return [repr((each.shown.rule, each.shown.message, analysis.range(each.finding.span))) for each in analysis.found]


def test_a_folder_that_is_opened_is_judged_although_a_configuration_above_excludes_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    unit = tmp_path / "examples/robot.service"
    unit.parent.mkdir()
    unit.write_text("[Service]\nExecStart=/bin/true\nResart=always\n")
    (tmp_path / "bringup-lint.toml").write_text('exclude = ["/examples/"]\n')
    for folder, found in ((unit.parent, True), (tmp_path, False)):
        given = answer(Folder(str(folder), Registry.of(), lambda config: frozenset()), {})
        assert bool(given) is found


@pytest.mark.parametrize(
    ("top", "seed"),
    [("guide", 1), ("crosslayer", 3), pytest.param("guide", 2, marks=pytest.mark.slow)],
    indirect=["top"],
)
def test_edits_answer_as_from_nothing(top: Path, seed: int) -> None:
    chance = random.Random(seed)
    registry = Registry.of()
    kept = Folder(str(top), registry, lambda config: frozenset())
    documents: dict[str, Document] = {}
    assert answer(kept, documents)
    files = sorted(path for path in top.rglob("*") if path.suffix in (".service", ".yaml", ".xml", ".env", ".py"))
    for number in range(EDITS):
        path: Path = chance.choice(files)
        shown = documents.get(str(path))
        text = edited(shown.text if shown else path.read_text("utf-8"), chance)
        documents[str(path)] = Document(uri_of(str(path)), text, number)
        cold = Folder(str(top), registry, lambda config: frozenset())
        assert answer(kept, documents) == answer(cold, documents), path


def test_a_change_of_a_module_is_one_of_the_node_that_imports_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copytree(PROJECT / "fixtures/node/topic_name_invalid/bad_modules", tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "mower/mower/topics.py"
    registry = Registry.of()
    kept = Folder(str(tmp_path), registry, lambda config: frozenset())
    told = []
    for number, text in enumerate([path.read_text(), "", path.read_text().replace("-", "_"), path.read_text()]):
        documents = {str(path): Document(uri_of(str(path)), text, number)}
        cold = Folder(str(tmp_path), registry, lambda config: frozenset())
        told.append(sum("topic-name-invalid" in each for each in answer(kept, documents)))
        assert answer(kept, documents) == answer(cold, documents)
    assert told == [2, 0, 0, 2]


def test_a_base_of_another_file_is_the_one_of_now(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    base = "from rclpy.node import Node\n\n\nclass Base(Node):\n    {body}\n"
    (tmp_path / "arm.py").write_text("import rclpy\nfrom base import Base\n\n\nclass Arm(Base):\n    pass\n")
    (tmp_path / "base.py").write_text(base.format(body="pass"))
    kept = Folder(str(tmp_path), Registry.of(), lambda config: frozenset())
    for number, name in enumerate(("front", "rear")):
        text = base.format(body=f"def {name}(self):\n        pass")
        documents = {str(tmp_path / "base.py"): Document(uri_of(str(tmp_path / "base.py")), text, number)}
        answer(kept, documents)
        assert kept.last is not None
        (arm,) = (each for each in kept.last.robot.nodes.classes if each.name == "Arm")
        assert arm.method(name) is not None


@pytest.mark.parametrize("top", ["guide"], indirect=True)
def test_the_second_run_loads_no_rule(top: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept = Folder(str(top), Registry.of(), lambda config: frozenset())
    first = answer(kept, {})
    assert first

    def load(path: Path, rule_id: str) -> None:
        raise AssertionError(rule_id)

    monkeypatch.setattr("bringup_lint.registry.load", load)
    assert answer(kept, {}) == first
