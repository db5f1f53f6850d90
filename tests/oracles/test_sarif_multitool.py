"""Microsoft's SARIF Multitool validates what the schema cannot say.

The tool is the npm package ``@microsoft/sarif-multitool-linux``; it is found through ``SARIF_MULTITOOL`` (the
program), on the PATH, or below ``node_modules`` in the project or in the folder ``NPM_CONFIG_PREFIX``.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import jsonschema
import pytest

from bringup_lint.report import Report
from bringup_lint.report import render
from tests.conftest import PROJECT
from tests.lint import lint
from tests.report.sample import clean
from tests.report.sample import sample

PROGRAM = "node_modules/@microsoft/sarif-multitool-linux/Sarif.Multitool"
OFFLINE = """\
<?xml version="1.0" encoding="utf-8"?>
<Properties>
  <Properties Key="SARIF2006.UrisShouldBeReachable.Options">
    <Property Key="RuleEnabled" Value="Disabled" Type="Driver.RuleEnabledState" />
  </Properties>
</Properties>
"""
"""All its checks but the one that asks the network for every URI."""


@pytest.fixture(scope="module")
def multitool() -> Path:
    places = [os.environ.get("SARIF_MULTITOOL", ""), shutil.which("Sarif.Multitool") or ""]
    places += [os.path.join(prefix, PROGRAM) for prefix in (PROJECT, os.environ.get("NPM_CONFIG_PREFIX", ""))]
    for place in places:
        if os.access(place, os.X_OK):
            return Path(place)
    pytest.skip("the SARIF Multitool is not installed")


AGENT = {
    "TF_BUILD": "True",
    "SYSTEM_COLLECTIONURI": "https://dev.azure.com/mowers/",
    "SYSTEM_TEAMPROJECTID": "0b8f7e5c-5a10-4c34-9f5e-1f6f6a0c1d2e",
    "SYSTEM_DEFINITIONID": "12",
    "BUILD_DEFINITIONNAME": "bring-up",
    "SYSTEM_PHASEID": "3a3a2a60-14c7-570b-14a4-fa42ad92f52a",
    "SYSTEM_PHASENAME": "Job",
    "BUILD_SOURCEBRANCH": "refs/heads/main",
    "BUILD_BUILDID": "345",
}
"""What the agent of Azure Pipelines says of a build."""


OF_EACH = 5
"""Rules of each family."""


def complaints(multitool: Path, file: Path, rules: str = "Sarif;Gh") -> list[str]:
    settings = file.with_name("offline.xml")
    settings.write_text(OFFLINE, "utf-8")
    kinds = ["--rule-kind", rules, "--level", "Error;Warning", "--max-file-size-in-kb", "1000000"]
    run = subprocess.run(
        [multitool, "validate", file, *kinds, "--config", settings],
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )
    assert "Analysis completed successfully." in run.stdout, run.stdout + run.stderr
    said = [line for line in run.stdout.splitlines() if ": error " in line or ": warning " in line]
    return [line for line in said if "RuleExplicitlyDisabled" not in line]


@pytest.mark.parametrize("name", ["sample", "clean", "bare"])
def test_validates(multitool: Path, name: str, tmp_path: Path) -> None:
    report = {"sample": sample, "clean": clean, "bare": Report}[name]()
    file = tmp_path / f"{name}.sarif"
    file.write_text(render("sarif", report), "utf-8")
    assert complaints(multitool, file) == []


@pytest.mark.parametrize("name", ["sample", "clean", "bare"])
def test_azure_takes_it(multitool: Path, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for variable, value in AGENT.items():
        monkeypatch.setenv(variable, value)
    file = tmp_path / f"{name}.sarif"
    report = {"sample": sample, "clean": clean, "bare": Report}[name]()
    file.write_text(render("sarif", report), "utf-8")
    assert complaints(multitool, file, "Sarif;Ado") == []


def test_tool_does_complain(multitool: Path, tmp_path: Path) -> None:
    file = tmp_path / "wrong.sarif"
    file.write_text(render("sarif", sample()).replace('"ruleIndex": 0', '"ruleIndex": 99'), "utf-8")
    assert "SARIF1009" in "".join(complaints(multitool, file))


def test_findings_of_every_family_validate(multitool: Path, tmp_path: Path) -> None:
    options = ("--isolated", "--no-ignores", "--min-severity", "info", "--output-format", "sarif")
    families = sorted((PROJECT / "fixtures").glob("[a-z]*"))
    trees = (tree for family in families for tree in sorted(family.glob("*/bad"))[:OF_EACH])
    run = lint(*options, *trees, cwd=PROJECT)
    assert run.code == 1, run.stderr
    file = tmp_path / "fixtures.sarif"
    file.write_text(run.stdout, "utf-8")
    assert complaints(multitool, file) == []


@pytest.mark.parametrize("name", ["sample", "clean", "bare"])
def test_follows_the_official_schema(multitool: Path, name: str) -> None:
    schema = json.loads((multitool.parent / "sarif-2.1.0.json").read_text("utf-8-sig"))
    report = {"sample": sample, "clean": clean, "bare": Report}[name]()
    jsonschema.validate(json.loads(render("sarif", report)), schema)
