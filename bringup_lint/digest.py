"""BLAKE2 from where Python has it: ``hashlib`` loads OpenSSL too, which takes longer than to digest a small tree."""

from __future__ import annotations

TYPE_CHECKING = False  # an answer is given before typing is loaded
if TYPE_CHECKING:
    from hashlib import blake2b as _Digest


def blake2b(data: bytes, *, digest_size: int, key: bytes = b"") -> _Digest:
    """A digest of some data, as ``hashlib.blake2b`` makes it."""
    try:
        from _blake2 import blake2b as digest
    except ImportError:
        from hashlib import blake2b as digest
    return digest(data, digest_size=digest_size, key=key)
