"""Digests from where Python has them: ``hashlib`` loads OpenSSL too, which takes longer than to digest a small tree."""

from __future__ import annotations

TYPE_CHECKING = False  # an answer is given before typing is loaded
if TYPE_CHECKING:
    from collections.abc import Callable
    from hashlib import _Hash
    from hashlib import blake2b as _Digest


def blake2b(data: bytes, *, digest_size: int, key: bytes = b"") -> _Digest:
    """A digest of some data, as ``hashlib.blake2b`` makes it."""
    try:
        from _blake2 import blake2b as digest
    except ImportError:
        from hashlib import blake2b as digest
    return digest(data, digest_size=digest_size, key=key)


def new_sha256() -> Callable[[bytes], _Hash]:
    """What begins a digest, as ``hashlib.sha256`` does."""
    from importlib import import_module

    for name in ("_sha2", "_sha256"):  # of Python 3.12, and of those before
        try:
            found: Callable[[bytes], _Hash] = import_module(name).sha256
        except ImportError:
            continue
        return found
    from hashlib import sha256

    return sha256
