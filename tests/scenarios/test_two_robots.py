"""A repository that holds two robots with contradicting values: nothing is joined across them."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.lint import lint
from tests.scenarios.test_crosslayer_robot import DEFECTS

HERON = {
    "etc/robot/ros.env": """\
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
CYCLONEDDS_URI=file:///etc/robot/cyclonedds.xml
ROS_DOMAIN_ID=7
ROS_LOG_DIR=/var/lib/robot/log
""",
    "etc/robot/cyclonedds.xml": """\
<CycloneDDS xmlns="https://cdds.io/config">
  <Domain Id="7">
    <General>
      <Interfaces><NetworkInterface name="lan0"/></Interfaces>
      <AllowMulticast>false</AllowMulticast>
    </General>
    <Discovery>
      <ParticipantIndex>auto</ParticipantIndex>
      <MaxAutoParticipantIndex>2</MaxAutoParticipantIndex>
      <Peers><Peer address="localhost"/><Peer address="10.1.0.9"/></Peers>
    </Discovery>
    <Internal><SocketReceiveBufferSize min="8MB"/></Internal>
  </Domain>
</CycloneDDS>
""",
    "etc/netplan/60-robot.yaml": "network:\n  version: 2\n  ethernets:\n    lan0:\n      addresses: [10.1.0.5/24]\n",
    "etc/sysctl.d/60-heron.conf": "net.core.rmem_max = 8388608\n",
    "etc/udev/rules.d/70-heron.rules": 'SUBSYSTEM=="tty", ATTRS{serial}=="H1", SYMLINK+="robot/lidar"\n',
    "etc/fstab": "LABEL=root / ext4 defaults,ro 0 1\nLABEL=lib /var/lib ext4 defaults 0 2\n"
    "tmpfs /var/log tmpfs size=64M,mode=0755 0 0\n",
    "etc/systemd/journald.conf.d/heron.conf": "[Journal]\nStorage=volatile\n",
    "etc/tmpfiles.d/heron.conf": "e /var/lib/robot - - - 14d\ne /var/lib/robot/log - - - 14d\n",
    "etc/nftables.conf": "table inet filter {\n  chain input {\n    type filter hook input priority 0; policy drop;\n"
    "    udp dport 9150-9250 accept\n  }\n}\n",
    "etc/robot/keystore/enclaves/governance.xml": "<dds><domain_access_rules><domain_rule><domains><id>7</id></domains>"
    "</domain_rule></domain_access_rules></dds>\n",
    "etc/robot/keystore/enclaves/drive/permissions.p7s": "",
    "etc/robot/keystore/enclaves/drive/cert.pem": "",
    "etc/systemd/system/drive.service": """\
[Unit]
Description=Heron's drive
Wants=network-online.target
After=network-online.target watch.service

[Service]
User=heron
EnvironmentFile=/etc/robot/ros.env
ExecStart=/opt/ros/jazzy/bin/ros2 run heron_drive drive --ros-args --enclave /drive
KillSignal=SIGINT
StandardOutput=append:/var/lib/robot/drive.log

[Install]
WantedBy=multi-user.target
""",
    "src/heron_bringup/config/lidar.yaml": "lidar:\n  ros__parameters:\n    port: /dev/robot/lidar\n",
}

KITE = {
    "etc/robot/ros.env": """\
RMW_IMPLEMENTATION=rmw_fastrtps_cpp
FASTRTPS_DEFAULT_PROFILES_FILE=/etc/robot/fastdds.xml
ROS_DOMAIN_ID=42
ROS_LOG_DIR=/var/log/robot
""",
    "etc/robot/fastdds.xml": """\
<dds xmlns="http://www.eprosima.com">
  <profiles>
    <transport_descriptors>
      <transport_descriptor>
        <transport_id>wan</transport_id>
        <type>UDPv4</type>
        <sendBufferSize>4194304</sendBufferSize>
        <interfaceWhiteList><address>172.20.0.5</address></interfaceWhiteList>
      </transport_descriptor>
    </transport_descriptors>
  </profiles>
</dds>
""",
    "etc/netplan/60-robot.yaml": "network:\n  version: 2\n  ethernets:\n    wan0:\n      addresses: [172.20.0.5/24]\n"
    "    lan0:\n      optional: true\n      addresses: [10.9.0.5/24]\n",
    "etc/sysctl.d/60-kite.conf": "net.core.rmem_max = 425984\nnet.core.wmem_max = 8388608\n",
    "etc/udev/rules.d/70-kite.rules": 'SUBSYSTEM=="tty", ATTRS{serial}=="K1", SYMLINK+="robot/camera"\n',
    "etc/fstab": "LABEL=root / ext4 defaults 0 1\n",
    "etc/systemd/journald.conf.d/kite.conf": "[Journal]\nStorage=persistent\nSystemMaxUse=500M\n",
    "etc/nftables.conf": "table inet filter {\n  chain input {\n    type filter hook input priority 0; policy drop;\n"
    "    udp dport 17900-17999 accept\n  }\n}\n",
    "etc/logrotate.d/kite": "/var/log/robot/*.log {\n  size 200M\n  rotate 4\n  copytruncate\n}\n",
    "etc/systemd/system/watch.service": """\
[Unit]
Description=Kite's watch
Wants=network-online.target
After=network-online.target drive.service

[Service]
User=kite
EnvironmentFile=/etc/robot/ros.env
ExecStart=/opt/ros/jazzy/bin/ros2 run kite_watch watch --ros-args --enclave /watch
KillSignal=SIGINT
LogsDirectory=robot

[Install]
WantedBy=multi-user.target
""",
    "src/kite_bringup/config/camera.yaml": "camera:\n  ros__parameters:\n    port: /dev/robot/camera\n",
}


def overlay(robot: str, name: str) -> str:
    """Each robot in a folder of its own that is shaped like a root file system."""
    return f"robots/{robot}/{name}"


def plain(robot: str, name: str) -> str:
    """Each robot in a folder with one folder for each sort of file, none of which is called etc."""
    return f"{robot}/{name.removeprefix('etc/').replace('systemd/system/', 'units/').replace('robot/', 'environment/')}"


def mixed(robot: str, name: str) -> str:
    """One robot: all files in one root file system, the second robot's where the first has none."""
    return name


def found(folder: Path, layout) -> set[str]:
    for robot, files in (("heron", HERON), ("kite", KITE)):
        for name, text in files.items():
            path = folder / layout(robot, name)
            if layout is plain:
                text = text.replace(" watch.service", "").replace(" drive.service", "")
            if not path.exists():
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, "utf-8")
    run = lint("--output-format", "json", "--min-severity", "info", ".", cwd=folder)
    assert run.code in (0, 1), run.stderr
    return {each["rule"] for each in json.loads(run.stdout)["findings"]} & DEFECTS["crosslayer"].keys()


@pytest.mark.parametrize("layout", [overlay, plain])
def test_nothing_is_joined_across_robots(tmp_path: Path, layout) -> None:
    assert found(tmp_path, layout) == set()


def test_the_same_files_contradict_each_other_on_one_robot(tmp_path: Path) -> None:
    assert found(tmp_path, mixed) >= {
        "cyclonedds/socket-buffer-exceeds-sysctl",
        "fastdds/whitelist-interface-missing",
        "journald/persistent-on-tmpfs",
        "logrotate/larger-than-tmpfs",
        "sros2/enclave-missing",
        "systemd/ordering-cycle",
    }
