"""The command line as a user meets it: exit codes, selection, outputs, configuration, standard input."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

from bringup_lint import __version__
from tests.conftest import PROJECT
from tests.lint import lint

LATIN1 = "[Unit]\nDescription=R\xe4der\n[Service]\nExecStart=/bin/true\n".encode("latin-1")
CLEAN = "[Unit]\nDescription=One\n[Service]\nExecStart=/bin/true\n"


@pytest.fixture
def bad(tmp_path: Path) -> Path:
    (tmp_path / "robot.service").write_bytes(LATIN1)
    return tmp_path


@pytest.fixture
def clean(tmp_path: Path) -> Path:
    (tmp_path / "robot.service").write_text(CLEAN)
    return tmp_path


def only_lint(*arguments: str, cwd: Path):
    return lint("--select", "lint", "--output-format", "concise", *arguments, cwd=cwd)


def test_version() -> None:
    run = subprocess.run(
        [sys.executable, "-m", "bringup_lint", "--version"], capture_output=True, text=True, cwd=PROJECT
    )
    assert (run.returncode, run.stdout) == (0, f"bringup-lint {__version__}\n")


def test_clean_tree_exits_0(clean: Path) -> None:
    assert only_lint(cwd=clean) == (0, "", "")


def test_findings_exit_1(bad: Path) -> None:
    run = only_lint(cwd=bad)
    assert run.code == 1
    assert run.stdout.startswith("robot.service:1:1: error[lint/encoding]")
    assert run.stderr == ""


def test_exit_zero(bad: Path) -> None:
    assert only_lint("--exit-zero", cwd=bad).code == 0


@pytest.mark.parametrize(
    "arguments",
    [["--no-such-option"], ["--select", "no-such-rule"], ["--target-ros", "melodic"], ["--config", "absent.toml"]],
)
def test_wrong_usage_exits_2_with_a_word_on_stderr(clean: Path, arguments: list[str]) -> None:
    run = lint(*arguments, cwd=clean)
    assert run.code == 2
    assert run.stdout == ""
    assert run.stderr.strip()


def test_unknown_rule_gets_a_suggestion(clean: Path) -> None:
    assert "did you mean 'lint/encoding'?" in lint("--select", "lint/encodng", cwd=clean).stderr


def test_fail_on(bad: Path) -> None:
    (bad / "notes.xyz").write_text("x")
    assert lint("--select", "lint/unknown-kind", "notes.xyz", cwd=bad).code == 1
    assert lint("--select", "lint/unknown-kind", "--fail-on", "error", "notes.xyz", cwd=bad).code == 0


def test_ignore_takes_families_and_rules(bad: Path) -> None:
    assert only_lint("--ignore", "lint/encoding", cwd=bad).code == 0
    assert only_lint("--ignore", "lint", cwd=bad).code == 0


def test_command_name_as_path(bad: Path) -> None:
    (bad / "rules").mkdir()
    (bad / "robot.service").rename(bad / "rules/robot.service")
    assert only_lint("./rules", cwd=bad).stdout.startswith("rules/robot.service:1:1")


def test_several_outputs(bad: Path) -> None:
    run = lint(
        *("--select", "lint", "--output-format", "concise", "--output-format", "json", "--output-file", "x.json"),
        *("--output-format", "sarif", "--output-file", "x.sarif"),
        cwd=bad,
    )
    assert run.stdout.startswith("robot.service:1:1: error")
    assert json.loads((bad / "x.json").read_text())["version"] == 1
    assert json.loads((bad / "x.sarif").read_text())["version"] == "2.1.0"


def test_two_reports_cannot_share_standard_output(clean: Path) -> None:
    assert lint("--output-format", "json", "--output-format", "sarif", cwd=clean).code == 2


def test_output_file_that_cannot_be_written(clean: Path) -> None:
    run = lint("--output-format", "json", "--output-file", "absent/x.json", cwd=clean)
    assert run.code == 2
    assert "absent/x.json" in run.stderr


def test_stdin(clean: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-m", "bringup_lint", "--stdin-filename", "etc/x.service", "--select", "lint/encoding",
         "--output-format", "concise"],
        input=LATIN1,
        capture_output=True,
        cwd=PROJECT,
    )  # fmt: skip
    assert run.stdout.decode().startswith("etc/x.service:1:1: error[lint/encoding]")
    assert run.returncode == 1


def test_stdin_of_unknown_kind_says_so(clean: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-m", "bringup_lint", "--stdin-filename", "notes.xyz"],
        input=b"x",
        capture_output=True,
        cwd=PROJECT,
    )
    assert b"lint/unknown-kind" in run.stdout


def test_configuration_file(bad: Path) -> None:
    (bad / "bringup-lint.toml").write_text('ignore = ["lint/encoding"]\n')
    assert only_lint(cwd=bad).code == 0
    assert only_lint("--isolated", cwd=bad).code == 1


def test_pyproject_table(bad: Path) -> None:
    (bad / "pyproject.toml").write_text('[tool.bringup-lint]\nignore = ["lint/encoding"]\n')
    assert only_lint(cwd=bad).code == 0


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ('ignor = ["x"]', "unknown key 'ignor'; did you mean 'ignore'?"),
        ('select = "systemd"', "select must be a list of strings"),
        ('fail-on = "fatal"', "fail-on must be one of info, warning, error, not 'fatal'"),
        ("target-systemd = true", "target-systemd must be a whole number"),
        ("select = [", "bringup-lint.toml"),
    ],
)
def test_mistakes_in_the_configuration(clean: Path, text: str, complaint: str) -> None:
    (clean / "bringup-lint.toml").write_text(text)
    run = lint(cwd=clean)
    assert run.code == 2
    assert complaint in run.stderr
    assert len(run.stderr.strip().splitlines()) == 1


def test_severity_can_be_changed(bad: Path) -> None:
    (bad / "bringup-lint.toml").write_text('[severity]\n"lint/encoding" = "info"\n')
    assert only_lint(cwd=bad).stdout == ""
    assert "info[lint/encoding]" in only_lint("--min-severity", "info", cwd=bad).stdout


def test_exclude(bad: Path) -> None:
    assert only_lint("--exclude", "*.service", cwd=bad).code == 0


def test_found_configuration_never_loads_rules(bad: Path) -> None:
    (bad / "evil").mkdir()
    (bad / "evil/family").mkdir()
    (bad / "evil/family/x.py").write_text("open('ran', 'w').close()\n")
    (bad / "bringup-lint.toml").write_text('rules = ["evil"]\n')
    run = only_lint(cwd=bad)
    assert not (bad / "ran").exists()
    assert "'rules' is only read from a file named by --config" in run.stderr


def test_baseline(bad: Path) -> None:
    first = only_lint("--write-baseline", "known.json", cwd=bad)
    assert (first.code, first.stdout) == (0, "")
    assert first.stderr == "known.json now holds 1 finding: --baseline known.json reports what is new\n"
    assert only_lint("--baseline", "known.json", cwd=bad).code == 0
    (bad / "other.service").write_bytes(LATIN1)
    assert only_lint("--baseline", "known.json", cwd=bad).stdout.startswith("other.service:1:1")


def test_summary_says_what_is_known_and_what_is_gone(bad: Path) -> None:
    (bad / "other.service").write_bytes(LATIN1)
    assert "2 known to the baseline" in lint("--select", "lint", "--write-baseline", "known.json", cwd=bad).stdout
    (bad / "other.service").unlink()
    said = lint("--select", "lint", "--baseline", "known.json", cwd=bad).stdout
    assert "1 known to the baseline · 1 gone, but still in the baseline: --prune-baseline" in said


def test_prune_baseline(bad: Path) -> None:
    (bad / "other.service").write_bytes(LATIN1)
    only_lint("--write-baseline", "known.json", cwd=bad)
    (bad / "other.service").write_text(CLEAN)
    run = only_lint("--baseline", "known.json", "--prune-baseline", cwd=bad)
    assert (run.code, run.stdout) == (0, "")
    assert run.stderr == "known.json: 1 finding removed, 1 left\n  other.service: lint/encoding\n"
    again = only_lint("--baseline", "known.json", "--prune-baseline", cwd=bad)
    assert again.stderr == "known.json: 0 findings removed, 1 left\n"
    assert [entry["path"] for entry in json.loads((bad / "known.json").read_text())["findings"]] == ["robot.service"]


@pytest.mark.parametrize(
    "arguments",
    [
        ["robot.service"],
        ["--select", "netplan"],
        ["--ignore", "lint/encoding"],
        ["--min-severity", "error", "--config", "lower.toml"],
    ],
)
def test_what_a_run_cannot_find_is_not_gone(bad: Path, arguments: list[str]) -> None:
    (bad / "other.service").write_bytes(LATIN1)
    only_lint("--write-baseline", "known.json", cwd=bad)
    (bad / "lower.toml").write_text('[severity]\n"lint" = "info"\n')
    run = lint("--baseline", "known.json", "--prune-baseline", *arguments, cwd=bad)
    assert run.stderr == "known.json: 0 findings removed, 2 left\n"


def test_a_finding_below_the_lowest_severity_keeps_those_of_its_file_alone(bad: Path) -> None:
    (bad / "other.service").write_bytes(LATIN1)
    only_lint("--write-baseline", "known.json", cwd=bad)
    (bad / "robot.service").write_text(CLEAN)
    (bad / "lower.toml").write_text('[severity]\n"lint" = "info"\n')
    run = lint("--baseline", "known.json", "--prune-baseline", "--config", "lower.toml", cwd=bad)
    assert run.stderr == "known.json: 1 finding removed, 1 left\n  robot.service: lint/encoding\n"


@pytest.mark.parametrize("arguments", [[], ["--write-baseline", "b.json", "--baseline", "b.json"]])
def test_what_cannot_be_pruned_is_wrong_usage(bad: Path, arguments: list[str]) -> None:
    run = lint("--prune-baseline", *arguments, cwd=bad)
    assert (run.code, run.stdout) == (2, "")


def test_damaged_baseline_exits_2(bad: Path) -> None:
    (bad / "known.json").write_text("{")
    assert only_lint("--baseline", "known.json", cwd=bad).code == 2


def test_explain_prints_the_documentation(tmp_path: Path) -> None:
    run = lint("explain", "lint/encoding", cwd=tmp_path)
    assert run.code == 0
    assert "What it finds" in run.stdout


def test_explain_finds_the_rule_behind_a_log_line(tmp_path: Path) -> None:
    line = "robot.service:2: String is not UTF-8 clean, ignoring assignment"
    assert lint("explain", line, cwd=tmp_path).stdout.startswith("lint/encoding")


def test_explain_ranks_the_rules_of_a_log_line(tmp_path: Path) -> None:
    said = lint("explain", "rover.service: Main process exited, code=exited, status=217/USER", cwd=tmp_path).stdout
    assert "3 rules explain" in said and "a line of systemd" in said
    assert said.index("systemd/user-missing") < said.index("systemd/trailing-comment")
    assert "log line: status=217/USER" in said


def test_explain_of_a_line_that_is_not_a_defect(tmp_path: Path) -> None:
    run = lint("explain", "rcl node's context is invalid", cwd=tmp_path)
    assert run.code == 0
    assert run.stdout.startswith("'rcl node's context is invalid': Not a configuration defect.")
    known = lint("explain", "service declares mutually exclusive `network_mode` and `networks`", cwd=tmp_path).stdout
    assert "A defect of the configuration that no rule finds." in " ".join(known.split())


def test_the_settings_of_an_image_are_looked_for_in_the_image(tmp_path: Path) -> None:
    image = tmp_path / "image"
    (image / "etc").mkdir(parents=True)
    (image / "etc/robot.service").write_bytes(b"[Service]\nExecStart=/bin/true \xff\n")
    arguments = ("--select", "lint/encoding", "--root", "image", "/etc")
    assert lint(*arguments, cwd=tmp_path).code == 1
    (image / "bringup-lint.toml").write_text('ignore = ["lint/encoding"]\n')
    assert lint(*arguments, cwd=tmp_path).code == 0


def test_explain_of_nothing_known(tmp_path: Path) -> None:
    assert lint("explain", "no such words anywhere", cwd=tmp_path).code == 2


@pytest.mark.parametrize(
    "command", [("rules", "systemd"), ("explain", "site/torn"), ("explain", "a line"), ("completion", "bash"), (".",)]
)
def test_a_rule_of_the_user_that_cannot_be_loaded_is_named(tmp_path: Path, command: tuple[str, ...]) -> None:
    (tmp_path / "own/systemd").mkdir(parents=True)
    (tmp_path / "own/systemd/root_user.py").write_text("x =\n")
    run = lint(*command, "--rules", "own", cwd=tmp_path)
    assert (run.code, run.stdout) == (2, "")
    assert run.stderr.startswith("bringup-lint: ") and "own/systemd/root_user.py: " in run.stderr


def test_explain_takes_a_rule_without_its_family(tmp_path: Path) -> None:
    assert lint("explain", "network-target", cwd=tmp_path).stdout.startswith("systemd/network-target")
    assert "3 rules are called 'root-user'" in lint("explain", "root-user", cwd=tmp_path).stdout


@pytest.mark.parametrize(
    ("arguments", "hint"),
    [
        (("explain", "systemd"), "'systemd' is a family; bringup-lint rules systemd lists its rules"),
        (("explain", "systemd/network-targt"), "did you mean systemd/network-target?"),
        (("explain", "workspace"), "rules with this word in their names: compose/workspace-hidden, "),
        (("explain", "network"), " more\n"),
        (("--root", ".", "/absent"), "there is no '/absent' in .\n"),
        (("rules", "sytemd"), "did you mean 'systemd'?"),
        (("--select", "network-target"), "did you mean 'systemd/network-target'?"),
        (("--select", "systemd/foo"), "no rule or family is called 'systemd/foo'\n"),
        (("rulez",), "did you mean the command 'rules'?"),
    ],
)
def test_what_was_meant(tmp_path: Path, arguments: tuple[str, ...], hint: str) -> None:
    run = lint(*arguments, cwd=tmp_path)
    assert run.code and hint in run.stderr


@pytest.mark.parametrize("arguments", [("explain", "lint/encoding"), ("rules", "lint")])
def test_colour_when_it_is_asked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: tuple[str, ...]
) -> None:
    monkeypatch.delenv("NO_COLOR", raising=False)
    assert "\x1b[" not in lint(*arguments, cwd=tmp_path).stdout
    monkeypatch.setenv("FORCE_COLOR", "1")
    assert "\x1b[" in lint(*arguments, cwd=tmp_path).stdout


def test_rules_lists_every_rule(tmp_path: Path) -> None:
    from bringup_lint.registry import Registry

    listed = json.loads(lint("rules", "--output-format", "json", cwd=tmp_path).stdout)
    assert [rule["id"] for rule in listed] == list(Registry.of().paths)


def test_schema_accepts_what_is_documented(tmp_path: Path) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(lint("init", "--schema", cwd=tmp_path).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validate = jsonschema.Draft202012Validator(schema).is_valid
    assert validate({"select": ["systemd"], "severity": {"systemd/root-user": "error"}, "target-ros": "jazzy"})
    assert not validate({"selct": []})


def test_published_schema_is_current() -> None:
    from bringup_lint.config import schema

    assert json.loads((PROJECT / "docs/bringup-lint.schema.json").read_text()) == schema()


def test_a_file_of_a_repository_is_judged_with_the_rest_as_context(tmp_path: Path) -> None:
    subprocess.run(["git", "init", "-q"], cwd=tmp_path, check=True)
    (tmp_path / "sockets").mkdir()
    (tmp_path / "sockets/robot.socket").write_text("[Socket]\nListenStream=7411\n")
    (tmp_path / "robot.service").write_bytes(LATIN1)
    rules = "systemd/socket-missing-service,lint"
    run = lint("--select", rules, "--output-format", "concise", "sockets/robot.socket", cwd=tmp_path)
    assert run == (0, "", "")
    (tmp_path / "robot.service").unlink()
    run = lint("--select", rules, "--output-format", "concise", "sockets/robot.socket", cwd=tmp_path)
    assert "[systemd/socket-missing-service]" in run.stdout


def test_a_path_that_does_not_exist_is_a_usage_error(bad: Path) -> None:
    run = lint("robot.servce", "robot.service", cwd=bad)
    assert run == (2, "", "bringup-lint: there is no 'robot.servce'; did you mean 'robot.service'?\n")
    (bad / "etc").mkdir()
    assert "did you mean 'etc'?" in lint("etcc/", cwd=bad).stderr
    assert lint("--root", ".", "/absent", cwd=bad).code == 2
    assert "there is no 'absent'" in lint("graph", "absent", cwd=bad).stderr


def test_only_what_is_asked_for_is_reported(tmp_path: Path) -> None:
    """A file that another one names is read, and not judged."""
    subprocess.run(["git", "init", "-q"], cwd=tmp_path, check=True)
    unit = tmp_path / "etc/systemd/system/robot.service"
    unit.parent.mkdir(parents=True)
    unit.write_text("[Service]\nExecStart=/bin/true\nEnvironmentFile=/opt/rover/rover.env\n")
    (tmp_path / "opt/rover").mkdir(parents=True)
    (tmp_path / "opt/rover/rover.env").write_bytes(b"A=\xff\n")
    (tmp_path / "notes.service").write_text(CLEAN)
    assert "opt/rover/rover.env:1:1" in lint("--output-format", "concise", ".", cwd=tmp_path).stdout
    assert "rover.env" not in lint("--output-format", "concise", "notes.service", cwd=tmp_path).stdout


def test_options_may_precede_a_command(tmp_path: Path) -> None:
    run = lint("--no-color", "explain", "lint/encoding", cwd=tmp_path)
    assert (run.code, run.stdout.startswith("lint/encoding")) == (0, True)
    run = lint("--target-ros", "jazzy", "--isolated", "graph", "--format", "json", ".", cwd=tmp_path)
    assert (run.code, run.stdout[:1]) == (0, "{")
    run = lint("--format", "json", "graph", ".", cwd=tmp_path)
    assert (run.code, run.stdout[:1]) == (0, "{")
    (tmp_path / "robot.service").write_bytes(LATIN1)
    assert lint("--select", "lint", "--output-format", "concise", "--", "rules", cwd=tmp_path).code == 2
    assert only_lint("--min-severity=info", "robot.service", cwd=tmp_path).code == 1


@pytest.mark.parametrize("colour", [("--color", "{}"), ("--colour={}",)])
def test_colour_takes_the_words_of_other_programs(tmp_path: Path, colour: tuple[str, ...]) -> None:
    (tmp_path / "robot.service").write_bytes(LATIN1)
    for word, coloured in (("always", True), ("never", False), ("auto", False)):
        option = [part.format(word) for part in colour]
        for rest in (("explain", "lint/encoding"), ("rules", "lint"), ("--select", "lint", "robot.service")):
            run = lint(*option, *rest, cwd=tmp_path)
            assert run.stdout and run.code in (0, 1), run.stderr
            assert ("\x1b[" in run.stdout) == coloured
    assert lint("--color", "--", "never", cwd=tmp_path).code == 2
    assert lint("--color", "robot.service", cwd=tmp_path).stdout.count("\x1b[")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("-",), "standard input needs a name, which says what kind of file it is: --stdin-filename NAME"),
        (("--stdin-filename", "a.service", "."), "--stdin-filename checks standard input alone"),
        (("--stdin-filename", "a.service", "--root", "."), "--stdin-filename checks standard input alone"),
        (("--unsafe-fixes",), "--unsafe-fixes needs --fix"),
        (("--tracked",), "--tracked: "),
    ],
)
def test_what_would_have_no_effect_is_refused(clean: Path, arguments: tuple[str, ...], said: str) -> None:
    run = lint(*arguments, cwd=clean)
    assert (run.code, run.stdout) == (2, "")
    assert said in run.stderr


def test_a_dash_is_standard_input(tmp_path: Path) -> None:
    run = subprocess.run(
        [sys.executable, "-m", "bringup_lint", "--stdin-filename", "x.service", "--output-format", "concise", "-"],
        input=LATIN1,
        capture_output=True,
        cwd=PROJECT,
    )
    assert run.stdout.decode().startswith("x.service:1:1: error[lint/encoding]")


def test_untracked_files_are_left_out_when_that_is_asked_for(bad: Path) -> None:
    subprocess.run(["git", "init", "-q"], cwd=bad, check=True)
    assert only_lint("--tracked", ".", cwd=bad) == (0, "", "")
    assert only_lint(".", cwd=bad).code == 1
    subprocess.run(["git", "add", "robot.service"], cwd=bad, check=True)
    assert only_lint("--tracked", ".", cwd=bad).code == 1


def test_the_hook_judges_what_is_tracked() -> None:
    assert "entry: bringup-lint --tracked\n" in (PROJECT / ".pre-commit-hooks.yaml").read_text()


def test_a_report_says_that_no_file_was_checked(tmp_path: Path) -> None:
    (tmp_path / "notes.rst").write_text("hello\n")
    run = lint("notes.rst", cwd=tmp_path)
    assert run.code == 1
    assert "bringup-lint does not read this kind of file" in " ".join(run.stdout.split())
    assert "or leave it out" in " ".join(run.stdout.split())
    assert run.stdout.endswith("1 warning: no file was checked\n")


def test_help_lists_options_alone(tmp_path: Path) -> None:
    text = lint("--help", cwd=tmp_path).stdout
    assert text.count("[PATH]...") == 1
    assert "--root FOLDER" in text and "DIRECTORY" not in text + lint("fleet", "--help", cwd=tmp_path).stdout
