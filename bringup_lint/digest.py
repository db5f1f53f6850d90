"""BLAKE2 from where Python has it: ``hashlib`` loads OpenSSL too, which takes longer than to digest a small tree."""

from __future__ import annotations

try:
    from _blake2 import blake2b
except ImportError:
    from hashlib import blake2b

__all__ = ["blake2b"]
