"""The certificate reader against ``cryptography`` (the extra ``pki``): subjects and last days of bred certificates."""

from __future__ import annotations

import random
from datetime import datetime
from datetime import timedelta
from datetime import timezone

import pytest

from bringup_lint.parsers import certificate

x509 = pytest.importorskip("cryptography.x509", reason="needs pip install cryptography")

CERTIFICATES = 200
NAMES = ("/", "/lawn/driver", "/ünï/cödé", "sros2CA", "a" * 60)


def bred(chance: random.Random) -> tuple[str, str | None, datetime]:
    """A certificate in PEM, its common name and its end."""
    from cryptography.hazmat.primitives import hashes
    from cryptography.hazmat.primitives import serialization
    from cryptography.hazmat.primitives.asymmetric import ec
    from cryptography.hazmat.primitives.asymmetric import ed25519

    name = chance.choice((*NAMES, None))
    others = [x509.NameAttribute(oid, "Lawn") for oid in (x509.NameOID.ORGANIZATION_NAME, x509.NameOID.LOCALITY_NAME)]
    parts = chance.sample(others, chance.randint(0, 2))
    if name is not None:
        parts.insert(chance.randint(0, len(parts)), x509.NameAttribute(x509.NameOID.COMMON_NAME, name))
    subject = x509.Name(parts or others)
    year = datetime(chance.randint(1960, 2040), 1, 1, tzinfo=timezone.utc)
    start = year + timedelta(minutes=chance.randint(0, 500_000))
    end = start + timedelta(days=chance.randint(1, 20_000))
    algorithm = chance.choice((ec.SECP256R1(), None))
    key = ec.generate_private_key(algorithm) if algorithm else ed25519.Ed25519PrivateKey.generate()
    builder = x509.CertificateBuilder().subject_name(subject).issuer_name(subject).public_key(key.public_key())
    builder = builder.serial_number(chance.randint(1, 2**150)).not_valid_before(start).not_valid_after(end)
    if chance.random() < 0.5:
        builder = builder.add_extension(x509.BasicConstraints(ca=True, path_length=1), critical=True)
    made = builder.sign(key, hashes.SHA256() if algorithm else None)
    return made.public_bytes(serialization.Encoding.PEM).decode(), name, end


def test_own_reader_reads_what_cryptography_writes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(certificate, "_by_cryptography", lambda pem: pytest.fail("the own reader gave up"))
    chance = random.Random(9)
    for _ in range(CERTIFICATES):
        pem, name, end = bred(chance)
        assert certificate.parse(pem) == (name, end.date())


def test_what_the_own_reader_does_not_understand_is_left_to_cryptography(monkeypatch: pytest.MonkeyPatch) -> None:
    def give_up(data: bytes) -> certificate.Certificate:
        raise ValueError("odd")

    monkeypatch.setattr(certificate, "_read", give_up)
    pem, name, end = bred(random.Random(3))
    assert certificate.parse(pem) == (name, end.date())
    assert certificate.parse("-----BEGIN CERTIFICATE-----\nTk9ORQ==\n-----END CERTIFICATE-----\n") is None
