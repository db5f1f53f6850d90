"""A Wi-Fi key or name that hostapd or wpa_supplicant does not take.

## What it finds
- hostapd.conf: a `wpa_passphrase=` with fewer than 8 or more than 63 characters, a `wpa_psk=` that is not 64
  hexadecimal digits; quotes around `wpa_passphrase=` or `ssid=`, which become part of the value (a warning);
- wpa_supplicant.conf: a `psk=` in quotes with fewer than 8 or more than 63 characters, one without quotes that is not
  64 hexadecimal digits, and an `ssid=` without quotes that is not hexadecimal.

Templates and placeholders are not judged.

## Why it matters on a robot
The daemon refuses the whole file and ends: no access point, or no connection. With quotes in hostapd.conf, nobody gets
in with the passphrase that is written on the robot.

## Bad
```
network={
    ssid=yard
    psk=ourpassphrase
}
```

## Good
```
network={
    ssid="yard"
    psk="ourpassphrase"
}
```

## When to ignore it
Never: with quotes that are meant, choose another passphrase.

## References
- hostapd.conf(5), "wpa_passphrase"; wpa_supplicant.conf(5), "NETWORK BLOCKS"
- hostapd 2.10, config_file.c; wpa_supplicant 2.10, config.c: wpa_config_parse_psk(), wpa_config_parse_string()
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.templates import is_stand_in

OPTION = regex(
    r"^[ \t]*(?P<key>wpa_passphrase|wpa_psk|psk|ssid)=(?P<value>\"[^\"\n]*\"|[^\s#](?:[^\n#]*[^\s#])?)"
    r"(?=[ \t\r]*(?:#[^\n]*)?$)",
    re.M,
)
PLACEHOLDER = regex(r"__\w+__|<[^>]*>|[xX]+|\*+|\.+|-+|")
HEX = regex(r"(?:[\da-fA-F]{2})+")


@rule(
    "error",
    symptoms=[
        "invalid WPA passphrase length * (expected 8..63)",
        "Invalid passphrase length * (expected: 8..63)",
        "Invalid PSK *",
        "Failed to read or parse configuration",
    ],
)
def wifi_key(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("hostapd", "wpa-supplicant"):
        if source.judged and not source.template:
            judge = _of_access_point if source.kind == "hostapd" else _of_client
            for key, value in _options(source):
                plain = value.strip('"')
                if not is_stand_in(plain) and not PLACEHOLDER.fullmatch(plain):
                    yield from judge(key, value)


def _options(source: Source) -> Iterator[tuple[str, Located]]:
    return ((match["key"], source.located(*match.span("value"))) for match in OPTION.finditer(source.text))


def _of_access_point(key: str, value: Located) -> Iterator[Finding]:
    if key in ("wpa_passphrase", "ssid") and value.startswith('"'):
        end = "the network has them in its name" if key == "ssid" else "nobody gets in with the text between them"
        yield finding(
            value,
            f"hostapd takes the quotes of {key}= for a part of it: {end}",
            advice="remove the quotes",
            severity="warning",
            secrets=[value] if key != "ssid" else (),
        )
    elif key == "wpa_passphrase" and not 8 <= _bytes(value) <= 63:
        yield _length(value, _bytes(value), "hostapd")
    elif key == "wpa_psk" and not _is_key(value):
        yield _no_key(value, "write the passphrase as wpa_passphrase=")


def _of_client(key: str, value: Located) -> Iterator[Finding]:
    quoted = value.startswith('"')
    if key == "psk" and quoted and not 8 <= _bytes(value[1:-1]) <= 63:
        yield _length(value, _bytes(value[1:-1]), "wpa_supplicant")
    elif key == "psk" and not quoted and not value.startswith("ext:") and not _is_key(value):
        yield _no_key(value, "put the passphrase into quotes")
    elif key == "ssid" and not quoted and not value.startswith('P"') and not HEX.fullmatch(value):
        yield finding(
            value,
            f"Without quotes, ssid= is hexadecimal, and '{value}' is not: wpa_supplicant refuses the file",
            advice="put the name into quotes",
        )


def _bytes(text: str) -> int:
    """The length that the daemons count."""
    return len(text.encode("utf-8", "replace"))


def _is_key(value: str) -> bool:
    return len(value) == 64 and HEX.fullmatch(value) is not None


def _length(value: Located, length: int, daemon: str) -> Finding:
    return finding(
        value,
        f"A passphrase has 8 to 63 characters, this one {length}: {daemon} refuses the file and ends",
        advice="choose a longer passphrase" if length < 8 else "choose a shorter passphrase",
        secrets=[value],
    )


def _no_key(value: Located, advice: str) -> Finding:
    return finding(
        value,
        "Without quotes, this has to be a key of 64 hexadecimal digits: the file is refused",
        advice=advice,
        secrets=[value],
    )
