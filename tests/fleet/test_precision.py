"""Five robots of one role, set up as an engineer does it: nothing is found. Then each defect is planted alone."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.fleet.test_fleet import judged
from tests.fleet.test_fleet import write

NAMES = ("alder", "birch", "cedar", "doum", "elm")
Files = dict[str, str]
Fleet = dict[str, Files]

UNIT = """\
[Unit]
Description=Bring-up of {name}
Wants=network-online.target
After=network-online.target

[Service]
User=robot
EnvironmentFile=/etc/robot/robot.env
Environment=ROS_LOG_DIR=/var/log/{name}
ExecStart=/usr/bin/ros2 launch rover_bringup rover.launch.py robot:={name} serial:={serial} id:={number}
Restart=on-failure
RestartSec=2

[Install]
WantedBy=multi-user.target
"""
TUNNEL = """\
[Unit]
Description=Reverse tunnel
Wants=network-online.target
After=network-online.target

[Service]
User=robot
ExecStart=/usr/bin/ssh -N -o ExitOnForwardFailure=yes -R {port}:localhost:22 tunnel@support.example.com
Restart=always
RestartSec=30

[Install]
WantedBy=multi-user.target
"""
NETWORK = """\
network:
  version: 2
  ethernets:
    lidar0:
      addresses: [192.168.1.1/24]
  wifis:
    wlan0:
      macaddress: 02:00:00:00:00:0{number}
      addresses: [10.7.0.{low}/24]
      routes: [{{to: default, via: 10.7.0.1}}]
"""
UDEV = 'SUBSYSTEM=="tty", ATTRS{{serial}}=="{serial}", SYMLINK+="base"\n'
ENVIRONMENT = """\
ROBOT_NAME={name}
ROS_DOMAIN_ID={domain}
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
CYCLONEDDS_URI=file:///etc/robot/cyclonedds.xml
"""
PARAMETERS = """\
/**:
  ros__parameters:
    robot_name: {name}
    frame_prefix: {name}/
    max_velocity: 1.2
    lidar_ip: 192.168.1.201
base:
  ros__parameters:
    serial_number: {serial}
    wheel_radius: {radius}
    wheel_separation: 0.41
    battery_installed: "2025-0{number}-12"
imu:
  ros__parameters:
    gyro_bias: [{bias}, 0.0, 0.0]
    mounting_yaw_offset: {yaw}
"""
CALIBRATION = """\
camera:
  ros__parameters:
    focal_length: {focal}
    center_x: {center}
"""
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package="rover_base", executable="base", name="base", namespace="{name}")])
"""
RADII = (0.0825, 0.0825, 0.0825, 0.0825, 0.0827)
YAWS = (0.0, 0.0, 0.0, 0.0, 0.012)
FOCALS = (612.5, 612.5, 612.5, 612.5, 609.9)


def _bytes(seed: str) -> bytes:
    return hashlib.sha256(seed.encode()).digest()


def key(seed: str) -> str:
    body = base64.b64encode(_bytes(seed) * 3).decode()
    return f"-----BEGIN PRIVATE KEY-----\n{body}\n-----END PRIVATE KEY-----\n"


def robot(at: int) -> Files:
    name = NAMES[at]
    values = {
        "name": name,
        "number": at + 1,
        "serial": f"RB24-{1017 + 13 * at}",
        "port": 2201 + at,
        "low": 20 + at,
        "domain": 11 + at,
        "radius": RADII[at],
        "bias": 0.001 * (at + 1),
        "yaw": YAWS[at],
        "focal": FOCALS[at],
        "center": 320.5 + at,
    }
    blob = base64.b64encode(b"\0\0\0\x0bssh-ed25519\0\0\0 " + _bytes(f"ssh {name}")).decode()
    return {
        "etc/hostname": f"{name}\n",
        "etc/hosts": f"127.0.0.1 localhost\n127.0.1.1 {name}\n",
        "etc/machine-id": _bytes(f"id {name}").hex()[:32] + "\n",
        "etc/os-release": "ID=ubuntu\nVERSION_ID=24.04\n",
        "etc/shadow": f"root:*:19000:0:99999:7:::\nrobot:$6$salt{name}${'Q' * 40}{name}:19000:0:99999:7:::\n",
        "etc/ssh/ssh_host_ed25519_key.pub": f"ssh-ed25519 {blob} root@{name}\n",
        "etc/wireguard/wg0.conf": "[Interface]\nAddress = 10.99.0.{low}/32\nPrivateKey = {key}\n".format(
            low=values["low"], key=base64.b64encode(_bytes(f"vpn {name}")).decode()
        ),
        "etc/hostapd/hostapd.conf": f"ssid={name}\nwpa=2\nwpa_passphrase={_bytes(f'ap {name}').hex()[:16]}\n",
        "etc/mosquitto/certs/client.key": key(f"tls {name}"),
        "etc/netplan/10-robot.yaml": NETWORK.format(**values),
        "etc/sysctl.d/60-dds.conf": "net.core.rmem_max = 2147483647\n",
        "etc/chrony/chrony.conf": "server 10.7.0.1 iburst\n",
        "etc/udev/rules.d/70-rover.rules": UDEV.format(**values),
        "etc/robot/robot.env": ENVIRONMENT.format(**values),
        "etc/robot/cyclonedds.xml": "<CycloneDDS/>\n",
        "etc/systemd/system/rover.service": UNIT.format(**values),
        "etc/systemd/system/tunnel.service": TUNNEL.format(**values),
        "opt/rover/share/rover_bringup/package.xml": (
            '<package format="3"><name>rover_bringup</name><version>1.0.0</version><description>Rover</description>'
            '<maintainer email="a@example.com">A</maintainer><license>MIT</license></package>\n'
        ),
        "opt/rover/share/rover_bringup/launch/rover.launch.py": LAUNCH.format(**values),
        "opt/rover/share/rover_bringup/config/rover.yaml": PARAMETERS.format(**values),
        "opt/rover/share/rover_bringup/config/camera_calibration.yaml": CALIBRATION.format(**values),
        "opt/keystore/enclaves/base/key.pem": key(f"enclave {name}"),
    }


def right() -> Fleet:
    return {name: robot(at) for at, name in enumerate(NAMES)}


def same(place: str) -> Callable[[Fleet], None]:
    """The second robot has a file of the first."""

    def plant(fleet: Fleet) -> None:
        fleet["birch"][place] = fleet["alder"][place]

    return plant


def other(place: str, before: str, after: str) -> Callable[[Fleet], None]:
    """The last robot differs."""

    def plant(fleet: Fleet) -> None:
        assert before in fleet["elm"][place]
        fleet["elm"][place] = fleet["elm"][place].replace(before, after)

    return plant


def gone(place: str) -> Callable[[Fleet], None]:
    return lambda fleet: fleet["elm"].pop(place) and None


def authority(fleet: Fleet) -> None:
    for name in ("alder", "birch"):
        fleet[name]["opt/keystore/private/ca.key.pem"] = key("ca")


def one_domain(fleet: Fleet) -> None:
    fleet["birch"]["etc/robot/robot.env"] = fleet["birch"]["etc/robot/robot.env"].replace("=12", "=11")


def one_node(fleet: Fleet) -> None:
    place = "opt/rover/share/rover_bringup/launch/rover.launch.py"
    fleet["birch"][place] = fleet["alder"][place]
    one_domain(fleet)


PARAMS = "opt/rover/share/rover_bringup/config/rover.yaml"
CYCLONE = "etc/robot/cyclonedds.xml"
TRACE = "<CycloneDDS><Domain><Tracing><Verbosity>finest</Verbosity></Tracing></Domain></CycloneDDS>"
TAG = "<CycloneDDS><Domain><Discovery><Tag>night</Tag></Discovery></Domain></CycloneDDS>"
ROVER = "etc/systemd/system/rover.service"
PAIR, LAST = ["alder", "birch"], ["elm"]
DEFECTS: dict[str, tuple[Callable[[Fleet], None], dict[str, list[str]]]] = {
    "ssh": (same("etc/ssh/ssh_host_ed25519_key.pub"), {"fleet/same-ssh-host-key": PAIR}),
    "machine-id": (same("etc/machine-id"), {"fleet/same-machine-id": PAIR}),
    "host-name": (same("etc/hostname"), {"fleet/same-host-name": PAIR}),
    "vpn": (same("etc/wireguard/wg0.conf"), {"fleet/same-network-key": PAIR}),
    "access-point": (same("etc/hostapd/hostapd.conf"), {"fleet/same-network-key": PAIR}),
    "tls": (same("etc/mosquitto/certs/client.key"), {"fleet/same-tls-key": PAIR}),
    "enclave": (same("opt/keystore/enclaves/base/key.pem"), {"fleet/same-sros2-key": PAIR}),
    "authority": (authority, {"fleet/same-sros2-key": PAIR}),
    "password": (same("etc/shadow"), {"fleet/same-password": PAIR}),
    "address": (same("etc/netplan/10-robot.yaml"), {"fleet/same-address": PAIR}),
    "tunnel": (same("etc/systemd/system/tunnel.service"), {"fleet/same-tunnel-port": PAIR}),
    "domain": (one_domain, {"fleet/same-domain": PAIR}),
    "pause": (other(ROVER, "RestartSec=2", "RestartSec=20"), {"fleet/drift": LAST}),
    "version": (other("etc/os-release", "24.04", "22.04"), {"fleet/drift": LAST}),
    "sysctl": (other("etc/sysctl.d/60-dds.conf", "2147483647", "212992"), {"fleet/drift": LAST}),
    "parameter": (other(PARAMS, "max_velocity: 1.2", "max_velocity: 2.0"), {"fleet/drift": LAST}),
    "middleware": (other("etc/robot/robot.env", "rmw_cyclonedds_cpp", "rmw_fastrtps_cpp"), {"fleet/drift": LAST}),
    "trace": (other(CYCLONE, "<CycloneDDS/>", TRACE), {"fleet/drift": LAST}),
    "time": (other("etc/chrony/chrony.conf", "10.7.0.1", "pool.ntp.org"), {"fleet/drift": LAST}),
    "unit": (gone("etc/systemd/system/tunnel.service"), {"fleet/missing-from-role": LAST}),
}
QUICK = ("ssh", "parameter", "unit")


def found(folder: Path, fleet: Fleet, talks: str = "separate", *, cwd: Path | None = None) -> dict[str, list[str]]:
    """Rule -> the robots that it names."""
    entries = [f'[[robot]]\nname = "{name}"\nrole = "rover"\nsite = "hall"\nroot = "{name}"\n' for name in fleet]
    write(folder, {"fleet.toml": f'[site.hall]\ndomains = "{talks}"\n\n' + "\n".join(entries)})
    for name, files in fleet.items():
        write(folder / name, files)
    findings = judged("--select", "fleet", str(folder), cwd=cwd or folder)["findings"]
    return {each["rule"]: each["robots"] for each in findings}


def test_nothing_is_found_on_robots_that_are_right(tmp_path: Path) -> None:
    assert found(tmp_path, right()) == {}


@pytest.mark.parametrize(
    "name", [pytest.param(each, marks=() if each in QUICK else pytest.mark.slow) for each in DEFECTS]
)
def test_each_defect_is_found_alone(name: str, tmp_path: Path) -> None:
    fleet = right()
    plant, expected = DEFECTS[name]
    plant(fleet)
    assert found(tmp_path, fleet) == expected


@pytest.mark.slow
def test_nodes_that_meet_in_one_domain(tmp_path: Path) -> None:
    fleet = right()
    one_node(fleet)
    assert found(tmp_path, fleet, "shared").get("fleet/same-node-name") == PAIR


@pytest.mark.slow
def test_a_robot_of_another_tag_is_not_heard(tmp_path: Path) -> None:
    fleet = right()
    other(CYCLONE, "<CycloneDDS/>", TAG)(fleet)
    assert found(tmp_path, fleet, "shared").get("fleet/different-middleware") == LAST


def test_where_the_user_keeps_the_robots_says_nothing_of_their_parameters(tmp_path: Path) -> None:
    fleet = right()
    other(PARAMS, "max_velocity: 1.2", "max_velocity: 2.0")(fleet)
    assert found(tmp_path / "fleet_calibration/robots", fleet, cwd=tmp_path) == {"fleet/drift": LAST}
