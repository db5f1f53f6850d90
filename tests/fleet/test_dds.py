"""What robots say of DDS: two usual ones and one that differs."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.fleet.test_fleet import judged
from tests.fleet.test_fleet import write

UNIT = """\
[Service]
Environment=RMW_IMPLEMENTATION={rmw}
{environment}
ExecStart=/opt/ros/jazzy/bin/ros2 launch rover_bringup rover.launch.py
"""
INVENTORY = '[site.hall]\ndomains = "shared"\n' + "".join(
    f'[[robot]]\nname = "{name}"\nsite = "hall"\nroot = "{name}"\n' for name in ("alpha", "beta", "gamma")
)
CYCLONE, FAST = "rmw_cyclonedds_cpp", "rmw_fastrtps_cpp"
PROFILES = '<participant profile_name="p" is_default_profile="true"><rtps>{}</rtps></participant>'
GAIN = "<Discovery><Ports><DomainGain>300</DomainGain></Ports></Discovery>"
TAG = "<Discovery><Tag>night</Tag></Discovery>"
ALONE = "<General><AllowMulticast>false</AllowMulticast></General><Discovery><Peers>{}</Peers></Discovery>"
HERE, ELSEWHERE = '<Peer Address="127.0.0.1"/>', '<Peer Address="10.0.0.7"/>'
BASE = "<port><portBase>7500</portBase></port>"
PEERS = "<initialPeersList><locator><udpv4><address>10.0.0.7</address></udpv4></locator></initialPeersList>"
URI = "Environment=CYCLONEDDS_URI=file:///etc/dds.xml"
FILE = "Environment=FASTRTPS_DEFAULT_PROFILES_FILE=/etc/dds.xml"


def differences(folder: Path, rmw: str, *robots: tuple[str, str]) -> list[str]:
    """The keys in which the last robot is not heard. Each robot has an environment and a file."""
    write(folder, {"fleet.toml": INVENTORY})
    for name, (environment, text) in zip(("alpha", "beta", "gamma"), robots, strict=True):
        unit = UNIT.format(rmw=rmw, environment=environment)
        write(folder / name, {"etc/systemd/system/rover.service": unit, "etc/dds.xml": text})
    findings = judged("--select", "fleet/different-middleware", ".", cwd=folder)["findings"]
    assert all(each["robots"] == ["gamma"] for each in findings)
    return [each["difference"]["key"] for each in findings]


def in_domain(text: str) -> str:
    return f"<CycloneDDS><Domain>{text}</Domain></CycloneDDS>"


def in_profiles(text: str) -> str:
    return f"<profiles>{PROFILES.format(text)}</profiles>"


@pytest.mark.parametrize(
    ("environment", "text", "expected"),
    [
        (URI, in_domain(TAG), ["domain tag"]),
        (URI, f"<CycloneDDS><Domain Id='7'>{TAG}</Domain></CycloneDDS>", []),
        (f"{URI}\nEnvironment=ROS_DOMAIN_ID=0", f"<CycloneDDS><Domain Id='7'>{TAG}</Domain></CycloneDDS>", []),
        (f"{URI},file:///etc/none.xml", in_domain(TAG), []),
        (URI, in_domain(TAG)[:-3], []),
        (URI, in_domain(ALONE.format(HERE)), ["way of discovery"]),
        (URI, in_domain(ALONE.format(HERE + ELSEWHERE)), []),
        (f"{URI}\nEnvironment=ROS_STATIC_PEERS=10.0.0.7", in_domain(ALONE.format(HERE)), []),
        (f"{URI}\nEnvironment=ROS_DOMAIN_ID=0", in_domain(GAIN), []),
        (f"Environment='CYCLONEDDS_URI={in_domain(TAG)}'", "", ["domain tag"]),
    ],
)
def test_cyclonedds(environment: str, text: str, expected: list[str], tmp_path: Path) -> None:
    usual = ("", "")
    assert differences(tmp_path, CYCLONE, usual, usual, (environment, text)) == expected


def test_the_port_is_that_of_the_domain(tmp_path: Path) -> None:
    usual = ("Environment=ROS_DOMAIN_ID=7", "")
    found = differences(tmp_path, CYCLONE, usual, usual, (f"{URI}\nEnvironment=ROS_DOMAIN_ID=7", in_domain(GAIN)))
    assert found == ["discovery port"]


@pytest.mark.parametrize(
    ("environment", "text", "expected"),
    [
        (FILE, in_profiles(BASE), ["discovery port"]),
        (FILE, in_profiles(f"<builtin>{PEERS}</builtin>{BASE}"), []),
        (FILE, in_profiles("<port><portBase>x</portBase></port>"), []),
        ("Environment=FASTDDS_BUILTIN_TRANSPORTS=SHM", "", ["transport"]),
        ("Environment=FASTDDS_BUILTIN_TRANSPORTS=LARGE_DATA", "", []),
        ("Environment=FASTRTPS_DEFAULT_PROFILES_FILE=/etc/none.xml", "", []),
        ("Environment=ROS_DISCOVERY_SERVER=10.0.0.5:11811", "", ["discovery protocol"]),
        ("Environment=ROS_DISCOVERY_SERVER=", "", []),
        ("Environment=ROS2_EASY_MODE=10.0.0.5", "", []),
    ],
)
def test_fastdds(environment: str, text: str, expected: list[str], tmp_path: Path) -> None:
    usual = ("", "")
    assert differences(tmp_path, FAST, usual, usual, (environment, text)) == expected
