"""The command, with the real bringup-lint."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest
from ament_bringup_lint.main import main
from ament_bringup_lint.xunit import Case
from ament_bringup_lint.xunit import document
from ament_bringup_lint.xunit import suite_name

BAD = '[Service]\nExecStart=/opt/rover/drive\nEnvironment="A=1\n'
WARNED = 'SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", GROUP="dialout", MODE="0666"\n'
MANIFEST = """\
<package format="3">
  <name>rover</name>
  <version>0.1.0</version>
  <description>Rover</description>
  <maintainer email="dev@example.com">dev</maintainer>
  <license>MIT</license>
</package>
"""
GOOD = "*.log {\n    weekly\n    rotate 4\n    copytruncate\n}\n"


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "package.xml").write_text(MANIFEST)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def suite(file: Path) -> ElementTree.Element:
    return ElementTree.parse(file).getroot()


def test_a_problem_is_a_failed_case(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (package / "rover.service").write_text(BAD)
    assert main(["--xunit-file", "results/rover/bringup_lint.xunit.xml"]) == 1
    found = suite(package / "results/rover/bringup_lint.xunit.xml")
    cases = list(found)[:-1]
    assert found.get("name") == "rover.bringup_lint"
    assert found.get("tests") == found.get("failures") == str(len(cases)) and found.get("errors") == "0"
    assert any((case.get("name") or "").startswith("systemd/") for case in cases)
    assert "rover.service:3:" in capsys.readouterr().err


def test_a_good_package_has_one_case_that_passes(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (package / "rover.logrotate").write_text(GOOD)
    assert main(["--xunit-file", "rover.xml"]) == 0
    found = suite(package / "rover.xml")
    assert [found.get(name) for name in ("tests", "failures", "errors", "skipped")] == ["1", "0", "0", "0"]
    assert [len(case) for case in found.iter("testcase")] == [0]
    assert "no problems" in capsys.readouterr().out


def test_only_what_fails_is_reported(package: Path) -> None:
    (package / "99-rover.rules").write_text(WARNED)
    assert main(["--fail-on", "error"]) == 0
    assert main(["--fail-on", "warning"]) == 1


def test_excluded_files_are_not_checked(package: Path) -> None:
    (package / "old").mkdir()
    (package / "old/rover.service").write_text(BAD)
    assert main(["--exclude", "old/", "--", "."]) == 0
    assert main(["--exclude", "old/", "--"]) == 0
    assert main(["old"]) == 1


def test_a_wrong_configuration_is_an_error(package: Path) -> None:
    (package / "bringup-lint.toml").write_text('[severity]\n"no/such-rule" = "error"\n')
    assert main(["--xunit-file", "x.xml"]) == 2
    found = suite(package / "x.xml")
    assert found.get("errors") == "1" and found.get("failures") == "0"
    assert "no/such-rule" in (found.find("testcase/error").get("message"))


def test_the_name_of_the_suite() -> None:
    assert suite_name(Path("/w/build/rover/test_results/rover/bringup_lint.xunit.xml")) == "rover.bringup_lint"
    assert suite_name(Path("/w/rover/bringup_lint.xml")) == "rover.bringup_lint"


def test_characters_that_xml_cannot_hold() -> None:
    text = document("a.b", [Case("x", "a\x00b <&>", "\x1b[1m]]>")], "failure", 0.1234, "")
    failure = ElementTree.fromstring(text.encode()).find("testcase/failure")
    assert failure is not None and failure.get("message") == "a\ufffdb <&>" and failure.text == "\ufffd[1m]]>"
