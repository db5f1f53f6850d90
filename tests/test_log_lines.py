"""From a line of a log to the rule that explains it."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from fnmatch import fnmatch
from functools import cache
from pathlib import Path

import pytest

from bringup_lint.cli.explaining import JUDGED
from bringup_lint.facts import table
from bringup_lint.log_lines import Answer
from bringup_lint.log_lines import _holds
from bringup_lint.log_lines import explained
from bringup_lint.log_lines import speaker_of
from bringup_lint.registry import Registry
from bringup_lint.registry import Rule
from tests.conftest import PROJECT

FIRST = {
    "rover.service: Start request repeated too quickly.": "systemd/restart-unlimited",
    "rover.service: Failed with result 'start-limit-hit'.": "systemd/restart-unlimited",
    "rover.service: Failed at step USER spawning /opt/rover/run: No such process": "systemd/user-missing",
    "rover.service: Main process exited, code=exited, status=217/USER": "systemd/user-missing",
    "rover.service: Failed to load environment files: No such file or directory": "systemd/envfile-missing",
    "rover.service: State 'stop-sigterm' timed out. Killing.": "systemd/kill-signal-not-sigint",
    "systemd[1]: a.target: Found ordering cycle on b.service/start": "systemd/ordering-cycle",
    "/etc/systemd/system/a.service:9: Unknown key name 'StartLimitBurst' in section 'Service', ignoring.": (
        "systemd/key-in-wrong-section"
    ),
    "/etc/systemd/system/a.service:9: Unknown key name 'Colour' in section 'Service', ignoring.": "systemd/*",
    "/etc/systemd/system/a.service:9: Unknown key 'StartLimitBurst' in section [Service], ignoring.": (
        "systemd/key-in-wrong-section"
    ),
    "/etc/systemd/system/a.service:9: Unknown key 'Colour' in section [Service], ignoring.": "systemd/*unknown-key",
    "/etc/systemd/logind.conf:9: Unknown key 'Colour' in section [Login], ignoring.": "logind/unknown-key",
    "/etc/systemd/journald.conf:9: Unknown key name 'Colour' in section 'Journal', ignoring.": "journald/unknown-key",
    "/etc/systemd/logind.conf:9: Unknown key name 'Colour' in section 'Login', ignoring.": "logind/unknown-key",
    "/etc/systemd/system.conf:9: Unknown key name 'Colour' in section 'Manager', ignoring.": "system-conf/unknown-key",
    "rover.service: Failed at step EXEC spawning /opt/rover/run.sh: No such file or directory": (
        "systemd/execstartpre-missing-script"
    ),
    "rover.service: Failed at step EXEC spawning ros2: No such file or directory": "systemd/exec-bare-ros2",
    "rover.service: Failed to execute /opt/rover/run.sh: No such file or directory": "script/crlf-shebang",
    "rover.service: Failed to execute /opt/rover/run.sh: Exec format error": "script/no-shebang",
    "rover.service: Failed at step NAMESPACE spawning /bin/true: No such file or directory": (
        "systemd/readwritepaths-missing"
    ),
    "rover.service: Failed at step CHDIR spawning /bin/true: No such file or directory": (
        "systemd/protecthome-workspace"
    ),
    "rover.service: Failed to determine supplementary groups: No such process": "systemd/user-missing",
    "rover.service: Failed to run 'start' task: No such file or directory": "systemd/envfile-missing",
    "rover.service: Found dependency on rover.service/start": "systemd/ordering-cycle",
    "/etc/systemd/system/a.service:5: Failed to parse service type, ignoring: notyfy": "systemd/invalid-value",
    "/etc/netplan/50-rover.yaml:7:7: Error in network definition: unknown key 'dhcp'": "netplan/unknown-key",
    "keyfile: weird: invalid setting name 'weird'": "networkmanager/unknown-key",
    "invalid connection: 802-11-wireless.mode: 'infra' is not a valid Wi-Fi mode": "networkmanager/invalid-value",
    "keyfile: ipv4.addresses: ignoring invalid IPv4 address: Invalid IPv4 address '10.0.0.300'": (
        "networkmanager/invalid-value"
    ),
    "Unsupported config option for services.robot: 'restrat'": "compose/unknown-key",
    'Named volume "maps:/maps:rw" is used in service "robot" but no declaration was found in the volumes section.': (
        "compose/undefined-name"
    ),
    "services.robot.depends_on contains an invalid type, it should be an array, or an object": "compose/invalid-value",
    "exec /entrypoint.sh: no such file or directory": "script/crlf-shebang",
    "A dependency job for rover.service failed. See 'journalctl -xe' for details.": "systemd/device-*",
    "Timed out waiting for device /dev/disk/by-label/data.": "fstab/no-nofail",
    "bash: line 1: ros2: command not found": "env/ros2-not-sourced",
    "Package 'rover' not found: \"package 'rover' not found, searching: ['/opt/ros/humble']\"": "env/ros2-not-sourced",
    "[ERROR] [launch]: Caught exception in launch: executable 'drive' not found on the libexec directory '/opt/x'": (
        "launch/executable-missing"
    ),
    "parameter 'gain' has invalid type: expected [double] got [integer]": "params/int-for-double",
    "parameter 'port' has invalid type: expected [integer] got [double]": "params/double-for-int",
    "could not open port '/dev/ttyUSB1': [Errno 2] No such file or directory: '/dev/ttyUSB1'": "device/unstable-path",
    "[Errno 13] Permission denied: '/dev/ttyACM0'": "systemd/group-missing-for-device",
    "/dev/ttyUSB0: Permission denied": "systemd/group-missing-for-device",
    "/etc/udev/rules.d/70-rover.rules:3 Unknown group 'robots', ignoring.": "udev/group-unknown",
    "error: /etc/logrotate.d/rover:4 unknown group 'robots'": "logrotate/unknown-user",
    "RTNETLINK answers: Operation not supported": "can/not-configured",
    "1712000000.5 [7] drive: wlp2s0: does not match an available interface.": "cyclonedds/interface-not-in-netplan",
    "Invalid YAML at /etc/netplan/50-rover.yaml line 3 column 1: inconsistent indentation": "netplan/yaml-error",
    "[lifecycle_manager_navigation]: Failed to change state for node: amcl": "launch/lifecycle-unknown-node",
    "Ignoring invalid environment assignment 'export ROS_DOMAIN_ID=7': /etc/rover.env": "env/export-prefix",
    "[rcl]: 'localhost_only' is enabled, 'automatic_discovery_range' and 'static_peers' will be ignored.": (
        "env/ros-static-peers-ignored"
    ),
    "rclpy.exceptions.ParameterUninitializedException: The parameter 'gain' is not initialized: gain": (
        "params/file-key-mismatch"
    ),
    "FileNotFoundError: [Errno 2] No such file or directory: '$(find-pkg-share rover)/map.yaml'": (
        "params/substitution-without-allow-substs"
    ),
    "Unit rviz.service is added as a dependency to a non-existent unit multi-user.target.": (
        "systemd/user-unit-system-target"
    ),
    "Unable to negotiate with 10.0.0.2 port 22: no matching cipher found. Their offer: 3des-cbc": "sshd/weak-crypto",
    "error: stat of /home/rover/.ros/log/** failed: No such file or directory": "logrotate/globstar",
    '70-rover.rules:2 style: LABEL="rover_end" is unused.': "udev/label-unused",
    "2025-03-13 20:43:40,201 WARNING Found /var/run/reboot-required, rebooting": "host/apt-auto-reboot",
    "[controller_manager]: The 'type' param was not defined for 'arm'.": "launch/controller-untyped",
    " ! nav Published ports are discarded when using host network mode": "compose/bridge-network-ros",
    "[controller_manager]: No clock received, using time argument instead! Check your node's clock": ("*/use-sim-*"),
    "failed to increase socket receive buffer size to at least 10485760 bytes, current is 425984 bytes": (
        "cyclonedds/socket-buffer-exceeds-sysctl"
    ),
    "[UFW BLOCK] IN=eth0 OUT= SRC=10.0.0.7 DST=239.255.0.1 PROTO=UDP SPT=7412 DPT=7400 LEN=100": "firewall/dds-ports",
}
"""A line -> the rule that comes first."""
OTHER = {
    "rcl node's context is invalid, at ./src/rcl/node.c:404": "context was shut down",
    "permission denied while trying to connect to the Docker daemon socket at unix:///run/docker.sock": "group docker",
    "[INFO] [drive-1]: process started with pid [812]": "started a process",
    "rover.service: Failed with result 'timeout'.": "took longer than",
    "RTNETLINK answers: Device or resource busy": "while it is down",
    "rover.service: Main process exited, code=exited, status=1/FAILURE": "message is some lines above",
}
"""A line that no rule explains -> words of the reason."""
SPEAKERS = {
    "systemd[1]: rover.service: Deactivated successfully.": "systemd",
    "systemd-udevd[230]: video0: Failed to chown": "udev",
    "** (generate:77): WARNING **: x": "netplan",
    "sshd[12]: x": "sshd",
    "[RTPS_TRANSPORT_SHM Error] x": "Fast DDS",
    "1712000000.5 [7] drive: x": "Cyclone DDS",
    "[ERROR] [launch]: x": "launch",
    "[rcl]: x": "rcl",
    "[   12.345678] usb 1-1: x": "kernel",
    "hello": None,
}


@cache
def rules() -> list[Rule]:
    return list(Registry.of().all())


def answer(line: str) -> Answer:
    return explained(line, rules())


def first(line: str) -> str:
    return next((match.rule.id for match in answer(line).matches), "")


@pytest.mark.parametrize(("line", "rule"), FIRST.items())
def test_the_right_rule_comes_first(line: str, rule: str) -> None:
    assert fnmatch(first(line), rule)


@pytest.mark.parametrize(("line", "reason"), OTHER.items())
def test_a_line_that_no_rule_explains_has_its_reason(line: str, reason: str) -> None:
    found = answer(line)
    assert not found.matches and found.other is not None
    assert reason in found.other.reason


@pytest.mark.parametrize(("line", "program"), SPEAKERS.items())
def test_the_program_that_writes_the_line(line: str, program: str | None) -> None:
    speaker = speaker_of(line)
    assert (speaker.program if speaker else None) == program


def test_nothing_is_known_of_other_words() -> None:
    assert answer("no such words anywhere") == Answer()
    assert answer("drive: /opt/rover/maps/hall.pgm: No such file or directory") == Answer()
    assert answer("the topic /scan does not exist") == Answer()


def test_a_longer_known_line_wins_over_another_cause() -> None:
    assert first("user interrupted with ctrl-c (SIGINT) again, ignoring...") == "systemd/execstop-async-kill"
    assert answer("[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)").other


@pytest.mark.slow
def test_every_known_line_finds_its_rule() -> None:
    """Where several rules know a line, the rule is among those that are named."""
    lost = [
        (rule.id, symptom)
        for rule in rules()
        for symptom in rule.meta.symptoms
        if not any(symptom in match.rule.meta.symptoms for match in answer(symptom.replace("*", "x")).matches)
    ]
    assert lost == []


def test_speakers_name_families() -> None:
    families = {family.name for family in Registry.of().families}
    assert {name for row in table("logs/speakers") for name in row["families"].split()} <= families


def test_other_causes_name_rules_that_exist() -> None:
    ids = set(Registry.of().paths)
    families = {rule_id.partition("/")[0] for rule_id in ids}
    reasons = " ".join(row["reason"] for row in table("logs/other_causes"))
    named = {word for word in re.findall(r"\b[a-z0-9-]+/[a-z0-9-]+", reasons) if word.partition("/")[0] in families}
    assert named and named <= ids


def test_other_causes_name_their_source() -> None:
    assert [row["pattern"] for row in table("logs/other_causes") if not row["source"]] == []


def pasted() -> Iterator[tuple[str, str]]:
    for line in (PROJECT / "tests/log_lines.tsv").read_text("utf-8").splitlines():
        if not line.startswith("#"):
            text, _, rules = line.partition("\t")
            yield text, rules


def is_one_of(found: Answer, wanted: str) -> bool:
    given = found.matches[0].rule.id if found.matches else "?" if found.other else ""
    return any(fnmatch(given, each) if each != "?" else given == "?" for each in wanted.split("|"))


@pytest.mark.slow
def test_pasted_lines() -> None:
    wrong = [(line, wanted, first(line)) for line, wanted in pasted() if not is_one_of(answer(line), wanted)]
    assert wrong == []


@pytest.mark.parametrize("colour", ["\x1b[1;31m{}\x1b[0m", "#033[31m{}#033[0m", "^[[31m{}^[[0m"])
def test_colours_of_a_terminal_do_not_matter(colour: str) -> None:
    assert first(colour.format("rover.service: ") + colour.format("Start request repeated too quickly.")) == (
        "systemd/restart-unlimited"
    )


def test_words_that_pass_a_message_on_do_not_count() -> None:
    passed = "[ERROR] [launch]: Caught exception in launch (see debug for traceback): "
    assert first(passed + "launch configuration 'side' does not exist") == "launch/arg-used-before-declare"
    assert answer(passed + "something new").other


def test_a_number_at_the_end_of_a_known_line_is_whole() -> None:
    assert first("nav-1 exited with code 1") == "compose/restart-missing"
    assert answer("nav-1 exited with code 139").other


@pytest.mark.parametrize(
    ("line", "pattern", "held"),
    [
        ("exit 12, then exit 1", "exit 1", True),
        ("a exit 12, then exit 1", "a*exit 1", True),
        ("exit 139", "exit 1", False),
        ("exit 12, then exit 13", "exit 1", False),
        ("exit 1", "exit*1", True),
        ("exit 1", "exit*", True),
        ("robotcommand: gone", "command", False),
        ("robotcommand: command gone", "command", True),
    ],
)
def test_a_line_may_hold_the_end_of_a_pattern_later(line: str, pattern: str, held: bool) -> None:
    assert _holds(line, pattern) is held


SHORT = {"iface": "interface", "perms": "mode|permission", "ws": "workspace", "tf": "transform"}
LINES = os.environ.get("BRINGUP_LINT_LOG_LINES", "")


def collected() -> Iterator[tuple[str, str]]:
    for line in Path(LINES).read_text("utf-8").splitlines():
        if line and not line.startswith("#"):
            text, _, about = line.partition("\t")
            yield text, about


def is_about(found: Answer, about: str) -> bool:
    """Whether an answer is what ``about`` says: ids of rules (with ``*``), or words with which words of the
    documentation begin, as alternatives (``|``, ``/``); ``?`` is a line that no rule explains."""
    if about == "?":
        return found.other is not None
    rule = found.matches[0].rule if found.matches else None
    text = f"{rule.id} {rule.doc} {rule.meta.symptoms}" if rule else found.other.reason if found.other else ""
    return any(_fits(rule.id if rule else "", text.lower(), each) for each in about.split("|"))


def _fits(rule_id: str, text: str, about: str) -> bool:
    family = about.partition("/")[0]
    if any(known.name == family for known in Registry.of().families) and "/" in about:
        return fnmatch(rule_id, f"{about.rstrip('*')}*")
    return any(all(_says(text, word) for word in each.split()) for each in about.lower().split("/"))


def _says(text: str, word: str) -> bool:
    return re.search(rf"\b(?:{SHORT.get(word, re.escape(word))})", text) is not None


@pytest.mark.skipif(not LINES, reason="BRINGUP_LINT_LOG_LINES names no file")
@pytest.mark.corpus
def test_collected_lines() -> None:
    """BRINGUP_LINT_LOG_LINES names a file with a line, a tab and what the right rule is about."""
    lines = list(collected())
    wrong = [(line, about, first(line)) for line, about in lines if not is_about(answer(line), about)]
    for each in wrong:
        print(*each, sep="\n    ")
    assert len(wrong) <= len(lines) * 0.05


def test_few_words_in_another_order_are_no_match() -> None:
    for line in (
        "The value of parameter gain is set to 3, it should not be less",
        "The requested command interface not found: 'wheel/effort' in hardware component: 'base'.",
    ):
        assert answer(line).matches == ()


def test_a_line_without_the_path_of_a_known_line_is_no_match() -> None:
    assert first("PermissionError: [Errno 13] Permission denied: '/dev/rover'") == "systemd/group-missing-for-device"
    assert first("PermissionError: [Errno 13] Permission denied: '/srv/rover'") != "systemd/group-missing-for-device"


def test_one_common_word_in_a_line_of_an_unknown_program_is_no_match() -> None:
    assert answer("[static_tf-1] Old names of frames are deprecated here; see --help for others").matches == ()
    assert first("/etc/systemd/system/a.service:3: Key= is deprecated") == "systemd/legacy-key"


def test_a_defect_that_no_rule_finds_is_called_one() -> None:
    found = answer("[spawner-3] [ERROR] [spawner_arm]: parameters not found in parameter files: ['arm.yaml']")
    assert found.other is not None and found.other.configuration == "unjudged"


def test_other_causes_say_what_the_configuration_has_to_do_with_them() -> None:
    assert {row["configuration"] for row in table("logs/other_causes")} == set(JUDGED)


def test_two_words_of_another_program_are_no_match() -> None:
    """logrotate says of a file that it ignores it because of a pattern match."""
    assert answer("[WARNING]: log_path (existing) did not fit the pattern, ignoring: robots") == Answer()
