"""Security documents: what is read from them, and that nothing makes the readers fail."""

from __future__ import annotations

from datetime import date
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.discover.kinds import kind_of
from bringup_lint.model.sros2 import moment
from bringup_lint.parsers import certificate
from bringup_lint.parsers import sros2
from bringup_lint.parsers.sros2_policy import policy
from bringup_lint.source import Source
from tests.conftest import PROJECT

FIXTURES = PROJECT / "fixtures/sros2"
PERMISSIONS = (FIXTURES / "permissions_expired/good/keystore/enclaves/lawn/driver/permissions.xml").read_text("utf-8")
SIGNED = FIXTURES / "permissions_unsigned_newer/bad/keystore/enclaves/lawn/driver/permissions.p7s"
CERTIFICATE = FIXTURES / "cert_expired/bad/keystore/enclaves/lawn/driver/cert.pem"


def test_grant() -> None:
    (grant,) = sros2.permissions(Source("permissions.xml", PERMISSIONS)).grants
    assert (grant.enclave, grant.default) == ("/lawn/driver", "DENY")
    assert grant.rules[0].domains.covers(7)
    assert not grant.rules[0].domains.covers(8)
    assert "rt/lawn/cmd_vel" in grant.rules[0].subscribe


def test_signed_document_keeps_its_places() -> None:
    source = Source("permissions.p7s", SIGNED.read_text("utf-8"))
    (grant,) = sros2.permissions(source).grants
    line = source.text.split("\n")[grant.subject.line - 1]
    assert "CN=/lawn/driver" in line


def test_dates() -> None:
    assert moment("2026-01-01T00:00:00Z").date() == date(2026, 1, 1)
    assert moment("2026-01-01") is None
    assert moment("2026-02-30T00:00:00") is None


def test_certificate() -> None:
    found = certificate.parse(CERTIFICATE.read_text("utf-8"))
    assert found == ("/lawn/driver", date(2036, 11, 18))
    assert certificate.parse("-----BEGIN CERTIFICATE-----\nTk9UIE9ORQ==\n-----END CERTIFICATE-----\n") is None


def test_other_xml_is_not_claimed() -> None:
    for text in (
        "<launch/>",
        "<dds><profiles/></dds>",
        "<permissions><grant/></permissions>",
        "text <dds><permissions/></dds>",
    ):
        assert not kind_of("config/permissions.xml", lambda text=text: text).startswith("sros2")
    assert kind_of("config/permissions.xml", lambda: PERMISSIONS) == "sros2-permissions"


@given(st.data())
def test_no_cut_makes_the_readers_fail(data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(PERMISSIONS)))
    end = data.draw(st.integers(start, len(PERMISSIONS)))
    source = Source("permissions.xml", PERMISSIONS[:start] + data.draw(st.text(max_size=5)) + PERMISSIONS[end:])
    for model in (sros2.permissions(source), sros2.governance(source)):
        for remark in model.remarks:
            span = getattr(remark.where, "span", remark.where)
            assert 0 <= span.start <= span.end <= len(source.text)


@given(st.binary(max_size=80))
def test_no_certificate_makes_the_reader_fail(data: bytes) -> None:
    from base64 import b64encode

    certificate.parse(f"-----BEGIN CERTIFICATE-----\n{b64encode(data).decode()}\n-----END CERTIFICATE-----\n")


def test_every_fixture_key_is_a_fake() -> None:
    for path in Path(FIXTURES).rglob("*key.pem"):
        assert "Tk9UIEEgS0VZLCBPTkxZIEEgRklYVFVSRQ==" in path.read_text("utf-8")


POLICY = (FIXTURES / "policy_grants_nothing/good/config/policy.xml").read_text("utf-8")


def test_policy() -> None:
    found = policy(Source("policy.xml", POLICY))
    (enclave,) = found.enclaves
    assert (enclave.path, enclave.open, found.remarks) == ("/lawn/driver", False, [])
    driver, watch = enclave.profiles
    assert (driver.fqn, watch.fqn) == ("/lawn/driver", "/watch")
    assert [str(right.name) for right in driver.rights if right.allows("publish")] == ["odom", "~/state", "/rtk/fix"]
    assert kind_of("any/rights.xml", lambda: POLICY) == "sros2-policy"


def test_what_a_policy_includes_is_never_read_and_stays_open() -> None:
    text = POLICY.replace("<profile ns", '<xi:include href="/etc/passwd" parse="text"/><profile ns', 1)
    (enclave,) = policy(Source("policy.xml", text)).enclaves
    assert enclave.open
    assert "root:" not in str([right.name for profile in enclave.profiles for right in profile.rights])


@given(st.integers(0, len(POLICY)), st.integers(0, 40), st.text(alphabet='<>&;/a" =!-[]', max_size=12))
def test_no_policy_makes_the_reader_fail(start: int, size: int, put_in: str) -> None:
    text = POLICY[:start] + put_in + POLICY[start + size :]
    found = policy(Source("policy.xml", text))
    for remark in found.remarks:
        span = remark.where if isinstance(remark.where, tuple) else remark.where.span
        assert 0 <= span.start <= span.end <= len(text)


def test_attacks_on_a_policy_cost_no_time_and_are_named() -> None:
    bomb = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 10))
    deep = "<enclave>" * 100_000
    for text in (
        f'<!DOCTYPE policy [<!ENTITY e0 "x">{bomb}]><policy version="0.2.0"><enclaves>&e9;</enclaves></policy>',
        '<!DOCTYPE policy SYSTEM "http://192.0.2.1/x.dtd"><policy version="0.2.0"><enclaves/></policy>',
        f'<policy version="0.2.0"><enclaves>{deep}',
    ):
        found = policy(Source("policy.xml", text))
        assert [remark.code for remark in found.remarks if remark.code == "xml"]
        assert len(found.remarks) < 100


def test_domains_of_an_unknown_kind_may_be_any() -> None:
    text = PERMISSIONS.replace("<domains>", "<domains><tag>7</tag>", 1)
    (grant,) = sros2.permissions(Source("permissions.xml", text)).grants
    assert not grant.rules[0].domains.known
    (grant,) = sros2.permissions(Source("permissions.xml", PERMISSIONS)).grants
    assert grant.rules[0].domains.known
