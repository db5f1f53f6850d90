"""The examples in the README and in ``docs/`` are what the command really prints.

``--update-expected`` rewrites them. An example is a code block below a comment that says how it was made:
``<!-- example: bringup-lint --select x . -->``, with ``in FOLDER`` before the colon when it runs elsewhere
than in the project, and ``| /runs/0`` (a JSON pointer) after it when only a part of the output is shown.
``<!-- picture NAME: bringup-lint ... -->`` draws the output instead.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.docs.picture import picture
from tests.lint import lint

CONTRIBUTING = PROJECT / "CONTRIBUTING.md"
PAGES = [*PROJECT.glob("*.md"), *(PROJECT / "docs").rglob("*.md")]
EXAMPLE = re.compile(
    r"<!-- example(?: in (?P<folder>\S+))?: bringup-lint (?P<arguments>[^|>]*?)(?: \| (?P<pointer>\S+))? -->"
    r"\n(?P<fence>`{3,})\w+\n(?P<output>.*?)(?P=fence)\n",
    re.DOTALL,
)
PICTURE = re.compile(r"<!-- picture (?P<name>\S+)(?: in (?P<folder>\S+))?: bringup-lint (?P<arguments>.*?) -->\n")
COMMAND = re.compile(r"^bringup-lint ?(?P<arguments>.*?)(?: \| .*| {2,}#.*)?$", re.M)
ELSEWHERE = {"/etc": "etc", "/mnt/image": ".", "RULE": "systemd/network-target"}
"""Where the example stands for what a reader has."""

UNIT_WITH_A_TAB = '[Service]\nExecStart=/usr/bin/rover "front\tleft"\n'
LINK = re.compile(r"\]\((?!https?:|#|mailto:)([^)#\s]+)")


@pytest.fixture(autouse=True)
def eighty_columns(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "80")


def output(example: re.Match[str], *options: str) -> str:
    """What the command of an example prints."""
    folder = PROJECT / (example["folder"] or "")
    run = lint(*options, *shlex.split(example["arguments"]), cwd=folder)
    assert run.code in (0, 1), run.stderr
    return run.stdout


def shown(example: re.Match[str]) -> str:
    text = output(example)
    if not example["pointer"]:
        return text
    data = json.loads(text)
    for key in example["pointer"].strip("/").split("/"):
        data = data[int(key) if isinstance(data, list) else key]
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_examples_are_true(page: Path, update_expected: bool) -> None:
    text = page.read_text("utf-8")
    for example in reversed(list(EXAMPLE.finditer(text))):
        start, end = example.span("output")
        if update_expected:
            text = text[:start] + shown(example) + text[end:]
            page.write_text(text, "utf-8")
        assert text[start:].startswith(shown(example) + example["fence"]), example["arguments"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_pictures_are_true(page: Path, update_expected: bool) -> None:
    for example in PICTURE.finditer(page.read_text("utf-8")):
        drawn = picture(output(example, "--colour"), "bringup-lint")
        file = page.parent / example["name"]
        if update_expected:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(drawn, "utf-8")
        assert file.read_text("utf-8") == drawn


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page: Path) -> None:
    prose = re.sub(r"```.*?```", "", page.read_text("utf-8"), flags=re.DOTALL)
    for target in LINK.findall(prose):
        assert (page.parent / target).exists(), target


def commands() -> list[str]:
    text = "\n".join(page.read_text("utf-8") for page in PAGES)
    shells = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
    named = re.findall(r"`bringup-lint ([a-z-][^`]*)`", text)
    return sorted({command["arguments"] for shell in shells for command in COMMAND.finditer(shell)} | {*named})


def committed(folder: Path) -> None:
    """Make a repository of the folder, with one commit on main."""
    for words in (["init", "-q", "-b", "main"], ["add", "-A"], ["commit", "-qm", "first"]):
        name = ("-c", "user.name=t", "-c", "user.email=t@example.org")
        subprocess.run(["git", *name, *words], cwd=folder, check=True)


@pytest.mark.parametrize("command", commands())
def test_commands_run(command: str, tmp_path: Path) -> None:
    shutil.copytree(PROJECT / "docs" / "example", tmp_path / "robot")
    arguments = [ELSEWHERE.get(word, word) for word in shlex.split(command)]
    if arguments[0] in ("live", "server"):
        arguments.append("--help")  # which robot would be running here, and which editor?
    if "--since" in arguments:
        pytest.importorskip("dulwich")
        committed(tmp_path / "robot")
    if "--baseline" in arguments:
        lint("--write-baseline", arguments[arguments.index("--baseline") + 1], cwd=tmp_path / "robot")
    run = lint(*arguments, cwd=tmp_path / "robot")
    assert run.code in (0, 1) and "bringup-lint: " not in run.stderr, run.stderr


def test_the_configuration_of_the_readme_holds_in_any_tree(tmp_path: Path) -> None:
    shutil.copytree(PROJECT / "docs" / "example", tmp_path / "robot")
    block = (
        (PROJECT / "README.md").read_text("utf-8").partition("<!-- configuration -->\n```toml\n")[2].partition("```")[0]
    )
    write(tmp_path / "robot/bringup-lint.toml", block)
    run = lint("--output-format", "concise", ".", cwd=tmp_path / "robot")
    assert run.code == 1 and run.stderr == ""
    assert "error[systemd/root-user]" in run.stdout
    (tmp_path / "robot/deploy/units").mkdir(parents=True)
    write(tmp_path / "robot/bringup-lint.toml", block.replace('# "deploy', '"deploy'))
    assert lint(".", cwd=tmp_path / "robot").code == 1


def example_rule() -> str:
    text = CONTRIBUTING.read_text("utf-8")
    block = text.partition("   ```python\n")[2].partition("\n   ```\n\n   The docstring")[0]
    return textwrap.dedent(block)


def test_rule_of_the_way_in_works(tmp_path: Path) -> None:
    write(tmp_path / "rules/systemd/no_tabs.py", example_rule())
    write(tmp_path / "rover.service", UNIT_WITH_A_TAB)
    run = lint("--rules", "rules", "--select", "systemd/no-tabs", "--output-format", "concise", ".", cwd=tmp_path)
    assert run.stdout == "rover.service:2:11: warning[systemd/no-tabs] What will happen on the robot\n"


def test_rule_of_the_page_on_own_rules_works(tmp_path: Path) -> None:
    text = (PROJECT / "docs/own-rules.md").read_text("utf-8")
    rule = text.partition("<!-- own rule -->\n```python\n")[2].partition("```\n<!-- end -->")[0]
    described = text.rpartition("```toml\n")[2].partition("```")[0]
    write(tmp_path / "our_rules/site/domain_of_site.py", rule)
    write(tmp_path / "our_rules/site/family.toml", described)
    shutil.copytree(PROJECT / "docs" / "example", tmp_path / "robot")
    asked = ("--rules", "our_rules", "--select", "site/domain-of-site", "--output-format", "concise", "robot")
    said = "robot/etc/mower/ros.env:1:15: warning[site/domain-of-site] The robots of the site do not hear this one\n"
    assert lint(*asked, cwd=tmp_path) == (1, said, "")
    assert "domain-of-site" in lint("rules", "--rules", "our_rules", "site", cwd=tmp_path).stdout


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the project with the example rule and its fixtures, which have no expected text yet."""
    folder = tmp_path_factory.mktemp("checkout") / "bringup-lint"
    for part in ("bringup_lint", "rules", "tests"):
        shutil.copytree(PROJECT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__", "oracles"))
    shutil.copy(PROJECT / "pyproject.toml", folder)
    write(folder / "rules/systemd/no_tabs.py", example_rule())
    write(folder / "fixtures/systemd/no_tabs/bad/rover.service", UNIT_WITH_A_TAB)
    write(folder / "fixtures/systemd/no_tabs/good/rover.service", UNIT_WITH_A_TAB.replace("\t", " "))
    return folder


@pytest.mark.slow
@pytest.mark.parametrize("word", ["no_tabs", "no-tabs"])
def test_expectation_of_the_way_in_is_written(word: str, checkout: Path) -> None:
    (command,) = re.findall(
        r"`\.venv/bin/(pytest [^`]* -k no_tabs --update-expected)`", CONTRIBUTING.read_text("utf-8")
    )
    expected = checkout / "fixtures/systemd/no_tabs/expected.txt"
    expected.unlink(missing_ok=True)
    words = command.replace("no_tabs", word).split()
    environment = {name: value for name, value in os.environ.items() if name != "PYTEST_ADDOPTS"}
    run = subprocess.run(
        [sys.executable, "-m", *words], capture_output=True, text=True, cwd=checkout, env=environment, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert expected.read_text("utf-8") == (
        "rover.service:2:11: warning[systemd/no-tabs] What will happen on the robot\n"
    )


def write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


def test_every_page_is_in_the_index() -> None:
    index = (PROJECT / "docs" / "README.md").read_text("utf-8")
    pages = [path.name for path in (PROJECT / "docs").iterdir() if path.suffix in (".md", ".json")]
    assert [name for name in pages if name != "README.md" and f"({name})" not in index] == []


def test_every_layer_is_in_the_map() -> None:
    text = (PROJECT / "CONTRIBUTING.md").read_text("utf-8")
    layers = [path.parent.name for path in (PROJECT / "bringup_lint" / "graph").glob("*/__init__.py")]
    assert [name for name in layers if f"`{name}`" not in text] == []
