"""Software is installed without a check of where it comes from.

## What it finds
In scripts and Dockerfiles:

- `deb [trusted=yes] ...`, `apt-get --allow-unauthenticated`, `--force-yes`, `AllowUnauthenticated=true` and
  `AllowInsecureRepositories=true`: apt installs packages that nobody signed;
- a key for apt that `wget` or `curl` gets over `http://`, and that goes to `apt-key add`, `gpg --dearmor` or a folder
  of keys, and `apt-key adv --fetch-keys http://...`, also with the shorter `--fetch-key`;
- in Dockerfiles, `wget --no-check-certificate` and `curl --insecure` of a file on the internet.

Repositories in a local folder and addresses of the own network are not reported.

## Why it matters on a robot
Whoever is between the robot and the server, in the wifi of a fair or at the customer's, gives it a package of his own,
and its installation runs as root.

## Bad
```dockerfile
RUN echo "deb [trusted=yes] https://download.example.org/debian/ /" > /etc/apt/sources.list.d/example.list
```

## Good
```dockerfile
ADD https://download.example.org/key.asc /etc/apt/keyrings/example.asc
RUN echo "deb [signed-by=/etc/apt/keyrings/example.asc] https://download.example.org/debian/ /" \\
    > /etc/apt/sources.list.d/example.list
```

## When to ignore it
When the file is compared with a checksum of its own afterwards.

## References
- apt-secure(8), sources.list(5): Trusted
- CWE-494: Download of Code Without Integrity Check
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

OWN_NETWORK = (
    r"(?:localhost|127\.|10\.|192\.168\.|172\.(?:1[6-9]|2\d|3[01])\."
    r"|[\w-]+(?:\.[\w-]+)*\.(?:local|lan|internal|home)\b|[\w-]+[:/\s])"
)
"""Private addresses (RFC 1918), and names that only the own network knows."""
UNSIGNED = regex(
    r"\bdeb \[[^\]\n]{0,200}\b(?P<trusted>trusted=yes)\b[^\]\n]{0,200}\]"
    rf"(?! *(?:file:|copy:|cdrom:|\.?/|[\"']?\$|https?://{OWN_NETWORK}))"
    r"|(?P<option>(?:APT::Get::AllowUnauthenticated|Acquire::AllowInsecureRepositories)(?==(?:true|1|yes)\b))"
    r"|\bapt(?:-get)?\b[^\n|;&]{0,200}?(?P<asked>--allow-unauthenticated|--force-yes)\b",
    hints="trusted=yes AllowUnauthenticated AllowInsecureRepositories --allow-unauthenticated --force-yes",
)
UNCHECKED = regex(
    r"\b(?:wget\b[^\n|;&]{0,200}?(?P<wget>--no-check-certificate)|curl\b[^\n|;&]{0,200}? (?P<curl>-k|--insecure) )"
)
PART = r"(?:[^\n|;&\\]|\\\n?)"
"""A character of a command, the end of a continued line included."""
PLAIN_HTTP = rf"(?<!proxy )(?<!proxy=)(?<!-x )http://(?!\$|{OWN_NETWORK})[^\s|;'\"\\]{{1,300}}"
FOLDERS = r"/(?:usr/share/keyrings|etc/apt/(?:keyrings|trusted\.gpg\.d))/"
KEY = regex(
    rf"\b(?:curl|wget)\b{PART}{{0,200}}?(?P<piped>{PLAIN_HTTP}){PART}{{0,100}}\|\s*(?:\\\n\s*)?"
    r"(?:sudo\s+(?:-\w+\s+){0,3})?(?:apt-key\s+add|gpg2?\b[^\n|;&]{0,100}--dearmor)"
    rf"|\b(?:curl|wget)\b{PART}{{0,200}}?(?P<saved>{PLAIN_HTTP}){PART}{{0,100}}?-[oO] ?{FOLDERS}"
    rf"|\b(?:curl|wget)\b{PART}{{0,100}}?-[oO] ?{FOLDERS}\S{{1,100}}{PART}{{0,100}}?(?P<before>{PLAIN_HTTP})"
    rf"|\bapt-key\b{PART}{{0,100}}?--fetch-keys?\s+[\"']?(?P<fetched>{PLAIN_HTTP})",
    hints="http:// apt-key",
)
UNSIGNED_INSTALLS = (
    "apt also installs what nobody signed: whoever has the server or the way to it can have any package installed"
)
SIGNED_BY = "import the key of the repository and name it with signed-by="
ADDRESS = regex(r"https://(?P<host>[a-zA-Z][\w-]*(?:\.[\w-]+)+)(?P<path>/\S*)?")
LOCAL = regex(r"\.(?:local|lan|internal|home)$")
LOOKED_FOR = regex(r"\bgrep\b[^|;&]*$|\bsed\b[^|;&]*['\"]\\?/[^|;&]*$")
PRINTED = regex(r"\b(?:echo|printf|grep|sed)\b[^|;&]*$")
CHECKED = regex(r"\b(?:sha(?:1|256|512)sum|md5sum|gpg --verify|cosign)\b|--(?:with-)?fingerprint\b[^\n]{0,120}\bgrep\b")


@rule(
    "warning",
    tags=["CWE-494", "CWE-295"],
    silent="apt and wget are told to accept what they would refuse",
)
def unverified_source(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script", "dockerfile"):
        if source.judged and not source.template and source.origin is None:
            unsigned = [_word(source, match) for match in UNSIGNED.finditer(source.text) if _is_said(source, match)]
            trusts = [word for word in unsigned if word.endswith("=yes")]
            yield from _finding(unsigned, UNSIGNED_INSTALLS, SIGNED_BY if trusts else "remove the option")
            if not CHECKED.search(source.text):
                yield from _finding(
                    [_word(source, match) for match in KEY.finditer(source.text) if _is_said(source, match)],
                    "Whoever is on the way to the server can send another key, with which apt trusts packages of his",
                    "get the key over https",
                )
            if source.kind == "dockerfile" and not CHECKED.search(source.text):
                yield from _finding(
                    list(_unchecked(source)),
                    "This file comes from whoever answers: the certificate of the server is not checked",
                    "remove the option, and install ca-certificates",
                )


def _finding(places: list[Located], message: str, advice: str) -> Iterator[Finding]:
    if places:
        first, *others = places
        yield finding(first, message, advice=advice, related=[note(other, "and here") for other in others[:9]])


def _unchecked(source: Source) -> Iterator[Located]:
    """The options of downloads from the internet."""
    for match in UNCHECKED.finditer(source.text):
        rest = source.text[match.start() : match.end() + 400].replace("\\\n", " ").partition("\n")[0]
        address = ADDRESS.search(re.split(r"[|;]|&&", rest)[0])
        if address is not None and address["path"] and not LOCAL.search(address["host"]) and _is_said(source, match):
            yield _word(source, match)


def _word(source: Source, match: re.Match[str]) -> Located:
    name = match.lastgroup or ""
    return source.located(*match.span(name))


def _is_said(source: Source, match: re.Match[str]) -> bool:
    """Whether a match is neither a comment nor an option in a text that is printed."""
    line = source.line_before(match.start())
    if line.lstrip().startswith("#") or " # " in line:
        return False
    looks = LOOKED_FOR if match.lastgroup == "trusted" else PRINTED
    return not looks.search(line)
