"""Small readers of the host family: jails, and the commands that install packages."""

from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.graph.host.fail2ban import parse_jail
from bringup_lint.source import Source

JAIL = """\
[DEFAULT]
bantime = 1h   # an hour
[sshd]
enabled = true
port = 22
port = 2222
"""


def test_the_last_value_of_a_jail_wins():
    jail = parse_jail(Source("jail.local", JAIL))
    assert (jail.get("sshd", "port"), jail.get("DEFAULT", "bantime")) == ("2222", "1h")
    assert jail.get("sshd", "port").line == 6
    assert jail.get("nginx", "port") is None


@given(st.text(alphabet="[]a =#;\n\t", max_size=60))
def test_no_text_raises_and_every_span_lies_inside(text):
    for value in parse_jail(Source("jail.local", text)).values.values():
        assert 0 <= value.span.start <= value.span.end <= len(text)
