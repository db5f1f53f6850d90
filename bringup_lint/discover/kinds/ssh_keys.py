"""Keys of SSH: who may log in, and the private halves."""

from __future__ import annotations

from bringup_lint.discover.kinds import Kind
from bringup_lint.pattern import regex

_AUTHORIZED = regex(r"(?:^|/)authorized_keys2?$")
_PRIVATE = regex(r"(?:^|/)(?:ssh_host_\w+_key|id_(?:rsa|dsa|ecdsa|ed25519)(?:_sk)?)$")
_HEAD = regex(r"-----BEGIN (?:OPENSSH |RSA |EC |DSA )?PRIVATE KEY-----")

KINDS = (
    Kind("authorized-keys", lambda path, head: bool(_AUTHORIZED.search(path))),
    Kind("ssh-private-key", lambda path, head: bool(_PRIVATE.search(path)) and bool(_HEAD.match(head()))),
)
