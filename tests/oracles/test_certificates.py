"""The certificate reader against ``cryptography`` (the extra ``pki``): subjects and last days."""

from __future__ import annotations

import importlib.metadata
import importlib.util
import random
from datetime import date
from datetime import datetime
from datetime import timedelta
from datetime import timezone

import pytest

from bringup_lint.parsers import certificate
from tests.oracles.answers import Oracle

CERTIFICATES = 60
NAMES = ("/", "/lawn/driver", "/ünï/cödé", "sros2CA", "a" * 60)


def tool() -> str:
    """Such as ``cryptography 42.0.8``; without the number where it is not installed."""
    if importlib.util.find_spec("cryptography") is None:
        return "cryptography"
    return f"cryptography {importlib.metadata.version('cryptography')}"


def random_certificate(chance: random.Random) -> str:
    """In PEM, with or without a common name; its keys are new in every run."""
    from cryptography import x509
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
    return made.public_bytes(serialization.Encoding.PEM).decode()


def name_and_end(pem: str) -> tuple[str | None, str]:
    """The common name and the last day, as cryptography reads them."""
    from cryptography import x509

    certificate = x509.load_pem_x509_certificate(pem.encode())
    names = certificate.subject.get_attributes_for_oid(x509.NameOID.COMMON_NAME)
    return (str(names[0].value) if names else None), certificate.not_valid_after_utc.date().isoformat()


def test_own_reader_reads_what_cryptography_reads(answers: Oracle, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(certificate, "_by_cryptography", lambda pem: pytest.fail("the own reader gave up"))
    chance = random.Random(9)
    is_there = tool() != "cryptography"
    texts = [random_certificate(chance) for _ in range(CERTIFICATES)] if answers.real and is_there else []
    given = answers.of("cryptography/certificates", tool(), texts, lambda texts: list(map(name_and_end, texts)))
    assert len(given.pairs) >= CERTIFICATES
    for pem, (name, end) in given.pairs:
        assert certificate.parse(pem) == (name, date.fromisoformat(end))


@pytest.mark.skipif(tool() == "cryptography", reason="needs pip install cryptography")
def test_what_the_own_reader_does_not_understand_is_left_to_cryptography(monkeypatch: pytest.MonkeyPatch) -> None:
    def give_up(data: bytes) -> certificate.Certificate:
        raise ValueError("odd")

    monkeypatch.setattr(certificate, "_read", give_up)
    pem = random_certificate(random.Random(3))
    name, end = name_and_end(pem)
    assert certificate.parse(pem) == (name, date.fromisoformat(end))
    assert certificate.parse("-----BEGIN CERTIFICATE-----\nTk9ORQ==\n-----END CERTIFICATE-----\n") is None
