"""Values that are secret by their names are masked although no rule marks them."""

from __future__ import annotations

import re

import pytest

from bringup_lint.finding.redact import mask_of
from bringup_lint.finding.secret_forms import FORMS
from bringup_lint.finding.secret_forms import Form
from bringup_lint.finding.secrets import given_away
from bringup_lint.source import Source
from tests.growth import is_linear
from tests.report.planted import READABLE
from tests.report.planted import Planted
from tests.report.planted import planted


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
        ("<Password>\n  hunter22\n  more\n</Password>", "hunter22\n  more"),
        ("<password>hunter22\nthe rest is lost", "hunter22"),
        ("<name>dds.sec.auth.password</name>\n <value>hunter22</value>", "hunter22"),
        ('<arg name="mqtt_password" default="hunter22"/>', "hunter22"),
        ('<env name="TOKEN" value="hunter22"/>', "hunter22"),
        ("url: rtsp://admin:hunter22@10.0.0.9/front", "hunter22"),
        ("baseline: 'https:/user:hunter22@10.0.0.9/known.json' lies outside", "hunter22"),
        ("clone https:/glpat0123456789abcdef@host/robot.git", "glpat0123456789abcdef"),
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
        "scp robot:/etc/a:b@c .",
        "docker run -v data:/data:ro registry/robot@sha256",
        'echo "usage: $0 <network> <password>"\nset -e\n',
    ],
)
def test_no_secret(text: str) -> None:
    assert found(text) == []


def test_python_names_are_no_secrets() -> None:
    assert found("Node(password=LaunchConfiguration('x'), token='abc123')", "robot.launch.py") == ["abc123"]


def test_long_lines_take_linear_time() -> None:
    assert found("password" * 20_000 + "=x" + "y" * 20_000) == ["x" + "y" * 20_000]
    assert is_linear(lambda size: found("password" * size + "=x" + "y" * size), 2_000)


PLANTED = tuple(planted())


def test_enough_is_planted() -> None:
    assert len(PLANTED) >= 200
    assert len({each.secret for each in PLANTED}) == len(PLANTED)
    assert len(READABLE) >= 60


@pytest.mark.parametrize("each", PLANTED, ids=lambda each: f"{each.file}-{each.secret}")
def test_planted_secret_is_masked(each: Planted) -> None:
    source = Source(each.file, each.text)
    mask = mask_of((), [source])
    assert mask is not None, each.text
    assert each.secret not in mask.source(source).text, each.text


@pytest.mark.parametrize("text", READABLE)
def test_what_looks_alike_stays_readable(text: str) -> None:
    assert found(text + "\n") == []


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS, ids=lambda form: form.pattern.pattern[:60])
def test_forms_take_linear_time(form: Form) -> None:
    pieces = (
        "password",
        "pass",
        "--",
        "-",
        '"',
        "name: token ",
        "value: a,",
        "<value>",
        "echo a:",
        "curl ",
        "://a",
        " ",
        "\n",
        "a=b ",
        "Bearer a",
        "eyJaaaaaaaa.",
    )
    for piece in pieces:
        for start, unit in (("", piece), ("ENV ", piece), ("", f"token{piece}")):
            assert is_linear(lambda size, start=start, unit=unit: finds(form, start + unit * size), 500), (start, unit)


def finds(form: Form, text: str) -> list[re.Match[str]]:
    return list(form.pattern.finditer(text))
