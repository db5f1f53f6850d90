"""Values that are secret by their names are masked although no rule marks them."""

from __future__ import annotations

import pytest

from bringup_lint.finding.secrets import given_away
from bringup_lint.source import Source


def found(text: str, name: str = "robot.conf") -> list[str]:
    return [span.text for span in given_away(Source(name, text))]


@pytest.mark.parametrize(
    ("text", "secret"),
    [
        ("Environment=WIFI_PASSWORD=correct-horse OTHER=1", "correct-horse"),
        ('Environment="API_TOKEN=abc123def"', "abc123def"),
        ('export MQTT_PASSWORD="two words"', "two words"),
        ("      password: blue harbour # of the shed\n", "blue harbour"),
        ('access-points: {shed: {password: "blue harbour"}}', "blue harbour"),
        ("access-points: {shed: {password: blueharbour}}", "blueharbour"),
        ("\tpsk=4f2a99\n", "4f2a99"),
        ('{"client_secret": "s3cr3t"}', "s3cr3t"),
        ("ExecStart=/usr/bin/bridge --password hunter22 --port 1", "hunter22"),
        ("<password>hunter22</password>", "hunter22"),
        ("<name>dds.sec.auth.password</name>\n <value>hunter22</value>", "hunter22"),
        ('<arg name="mqtt_password" default="hunter22"/>', "hunter22"),
        ('<env name="TOKEN" value="hunter22"/>', "hunter22"),
        ("url: rtsp://admin:hunter22@10.0.0.9/front", "hunter22"),
        ("SetCredential=wifi:hunter22", "hunter22"),
        ("root_password: $6$abc$def", "$6$abc$def"),
        ("-----BEGIN EC PRIVATE KEY-----\nMHcCAQ\n-----END EC PRIVATE KEY-----", "\nMHcCAQ"),
    ],
)
def test_secret(text: str, secret: str) -> None:
    assert found(text) == [secret]


@pytest.mark.parametrize(
    "text",
    [
        "PASSWORD=${WIFI_PASSWORD}",
        "PASSWORD=$(cat /run/secrets/wifi)",
        "password: {{ wifi_password }}",
        "password: @WIFI_PASSWORD@",
        "password: <your password>",
        "password: !vault",
        "PASSWORD=",
        "PasswordAuthentication no",
        "password: true",
        "password_file: /etc/robot/password",
        "PRIVATE_KEY=/etc/robot/key.pem",
        "secrets:\n  wifi:\n    file: wifi.txt",
        "token_timeout: 30",
        "ExecStart=/usr/bin/bridge --password-file=/etc/robot/password",
        "private-key: /private/key.pem",
        "ImportCredential=network.dns",
        "http://10.0.0.9:8080/front",
    ],
)
def test_no_secret(text: str) -> None:
    assert found(text) == []


def test_python_names_are_no_secrets() -> None:
    assert found("Node(password=LaunchConfiguration('x'), token='abc123')", "robot.launch.py") == ["abc123"]


def test_long_lines_cost_no_time() -> None:
    assert found("password" * 200_000 + "=x" + "y" * 200_000) == ["x" + "y" * 200_000]
