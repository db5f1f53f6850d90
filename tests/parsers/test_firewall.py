"""What firewall scripts let in, and the arithmetic that they do."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.parsers.arithmetic import evaluate
from bringup_lint.parsers.firewall import parse
from bringup_lint.source import Source


def openings(text: str, kind: str = "shell-script") -> list[tuple[str, int | None, int | None]]:
    return [(each.protocol, each.first, each.last) for each in parse(Source("x", text, kind=kind)).openings]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("42", 42),
        ("$BASE", 17900),
        ("${BASE}", 17900),
        ("${OTHER:-7}", 7),
        ("$((7400 + 250 * DOMAIN))", 17900),
        ("$(( ($BASE - 7400) / 250 ))", 42),
        ("$((1 / 0))", None),
        ("$((UNSET + 1))", None),
        ("$(cat port)", None),
        ("$((1 2))", None),
    ],
)
def test_arithmetic(text, value):
    assert evaluate(text, {"DOMAIN": "42", "BASE": "17900"}) == value


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("ufw allow 7400:7700/udp", [("udp", 7400, 7700)]),
        (
            "sudo ufw allow proto udp from 10.0.0.0/24 to any port 7400,7410:7420",
            [("udp", 7400, 7400), ("udp", 7410, 7420)],
        ),
        ("ufw allow 22", [("", 22, 22)]),
        ("ufw allow ssh\nufw deny 7400/udp\nufw allow out 7400/udp", []),
        ("iptables -I INPUT -p udp --dport 7400:7500 -j ACCEPT", [("udp", 7400, 7500)]),
        ("iptables -A OUTPUT -p udp --dport 7400 -j ACCEPT", []),
        (
            "iptables -A INPUT -p udp -m multiport --dports 7400,7401 -j ACCEPT",
            [("udp", 7400, 7400), ("udp", 7401, 7401)],
        ),
        ("D=2\nP=$((7400 + 250 * D))\nufw allow $P/udp", [("udp", 7900, 7900)]),
        ("ufw allow $UNSET/udp", [("udp", None, None)]),
    ],
)
def test_openings(text, found):
    assert openings(text) == found


@pytest.mark.parametrize(
    ("text", "all_in"),
    [
        ("ufw allow from 10.0.0.0/24", True),
        ("ufw allow in on eth0", True),
        ("ufw default allow incoming", True),
        ("ufw default allow outgoing", False),
        ("iptables -A INPUT -i lo -j ACCEPT", False),
        ("iptables -A INPUT -i eth0 -j ACCEPT", True),
        ("iptables -A INPUT -m state --state ESTABLISHED -j ACCEPT", False),
        ("iptables -P INPUT ACCEPT", True),
        ("iptables -A INPUT -p icmp -j ACCEPT", False),
    ],
)
def test_whole_subnets(text, all_in):
    assert parse(Source("x", text, kind="shell-script")).opens_all is all_in


WORDS = [
    "ufw",
    "iptables",
    "-A",
    "INPUT",
    "-p",
    "udp",
    "--dport",
    "1:2",
    "-j",
    "ACCEPT",
    "allow",
    "port",
    "$X",
    "$((1+",
]


@given(
    st.lists(st.sampled_from([*WORDS, ";", "\n", "A=1", "!", "-L"]), max_size=14),
    st.sampled_from(["shell-script", "iptables-rules", "nftables"]),
)
def test_no_text_raises(words, kind):
    openings(" ".join(words), kind)
