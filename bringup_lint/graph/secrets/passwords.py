"""Passwords where no variable has their name: Wi-Fi configuration, and commands that set or use one."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_WIFI = {
    "hostapd": regex(r"^[ \t]*(?P<name>wpa_passphrase|wpa_psk|sae_password)=(?P<value>[^\n\r|]+)", re.M),
    "wpa-supplicant": regex(r"^[ \t]*(?P<name>psk|password|sae_password)=(?!ext:|hash:)\"?(?P<value>[^\n\r\"]+)", re.M),
    "networkmanager": regex(r"^(?P<name>psk|password|wep-key\d|private-key-password)=(?P<value>[^\n\r]+)", re.M),
    "code-server": regex(r"^(?P<name>password):[ \t]*[\"']?(?P<value>[^\s\"'#]+)[\"']?[ \t\r]*$", re.M),
}
"""Kind of file -> where it holds a password."""
_WORD = r"(?P<quote>[\"']?)(?P<value>[^\s\"'{}!#][^\s\"'{}#]*)(?P=quote)"
_VARIABLES = (
    regex(r"^[ \t]*[\"']?(?P<name>[A-Za-z_]\w*)[\"']?:[ \t]+" + _WORD + r"[ \t\r]*(?:#.*)?$", re.M),
    regex(r"(?<![\w#])(?P<name>ansible_\w*pass(?:word)?)[ \t]*=[ \t]*" + _WORD + r"(?=\s|$)"),
)
"""Variables of Ansible: YAML, and the words of an inventory."""
_LOGS_IN_NOWHERE = regex(r"(?m)^[ \t]*ansible_connection[ \t]*[=:][ \t]*[\"']?local\b", hints="ansible_connection")
_LOCAL = regex(r"localhost|127(?:\.\d{1,3}){3}|::1")

_SUDO = r"(?:sudo[ \t]+(?:-\w+[ \t]+)*)?"
_SECRET = r"(?P<value>[^\s\"'`$|;&<>\\{}]{1,100})"
_ACCOUNTS = (
    regex(
        r"\b(?:echo|printf)[ \t]+(?:-[en]+[ \t]+)*(?P<quote>[\"']?)(?P<user>[a-z_][\w-]{0,31}):"
        + _SECRET
        + r"(?:\\n)?(?P=quote)[ \t]*\|[ \t]*"
        + _SUDO
        + r"chpasswd\b(?![ \t]+(?:-e|--encrypted))"
    ),
    regex(
        r"\b(?:echo[ \t]+-e|printf)[ \t]+(?P<quote>[\"'])"
        + _SECRET
        + r"\\n(?P=value)(?:\\n)?(?P=quote)[ \t]*\|[ \t]*"
        + _SUDO
        + r"passwd\b(?:[ \t]+(?P<user>[a-z_][\w-]{0,31}))?"
    ),
)
"""Commands that set the password of a user."""
_ANSWER = r"\b(?P<program>expect)[ \t][^\n]{0,200}[Pp]assword[^\n?]{0,100}\n[ \t]*send[ \t]+(?:--[ \t]+)?\\?[\"']"
"""What a script of expect sends when it is asked for a password, and not whether it wants to change one."""
_REPLY = r"(?i:y|n|yes|no|exit|quit)"
"""What answers a question, or ends a program."""
_PROGRAMS = (
    regex(r"\b(?P<program>sshpass)[ \t]+-p[ \t]*(?P<quote>[\"']?)" + _SECRET + r"(?P=quote)(?=[ \t])", 0, "sshpass"),
    regex(
        r"\b(?P<program>x11vnc)[ \t][^\n|;&]{0,300}?-passwd[ \t]+(?P<quote>[\"']?)" + _SECRET + r"(?P=quote)(?=\s|$)",
        hints="x11vnc",
    ),
    regex(
        r"\b(?P<program>nmcli)[ \t][^\n|;&]{0,300}?[ \t](?:password|(?:wifi|802-11-wireless)-sec(?:urity)?\.psk)[ \t]+"
        r"(?P<quote>[\"']?)" + _SECRET + r"(?P=quote)(?=\s|$)",
        hints="nmcli",
    ),
    regex(
        r"\b(?P<program>openssl)[ \t](?:\\\r?\n|[^\n|;&]){0,600}?-pass(?:in|out)?[ \t]+(?P<quote>[\"']?)pass:"
        + _SECRET
        + r"(?P=quote)(?=\s|$)",
        hints="openssl",
    ),
    regex(_ANSWER + rf"(?!{_REPLY}\\)" + _SECRET + r"\\{1,2}[nr]", hints="expect"),
)
"""Commands that are given a password."""
_BY_VARIABLE = regex(
    r"\b(?P<program>nmcli|sshpass)[ \t][^\n|;&]{0,300}?"
    r"(?:-p|[ \t]password|[ \t](?:wifi|802-11-wireless)-sec(?:urity)?\.psk)[ \t]*"
    r"[\"']?\$\{?(?P<variable>\w{1,60})\}?[\"']?(?=\s|$)",
    hints="nmcli sshpass",
)
"""Commands that are given a password by a variable."""
_ANSWER_BY_VARIABLE = regex(_ANSWER + r"\$\{?(?P<variable>\w{1,60})\}?\\{1,2}[nr]", hints="expect")
_SET = regex(r"(?<![\w$])(?P<name>\w{1,60})(?P<more>\+?)=")
_VALUE = regex(rf"(?P<quote>[\"']?)(?!{_REPLY}(?:[\"' \t;]|$)){_SECRET}(?P=quote)(?=[ \t;]|$)", re.M)
_READ = regex(r"\bread\b(?P<names>[^\n]{0,160})", hints="read")
_NAME = regex(r"\w+")
_SHEDS = regex(
    r"\bopenssl[ \t]+(?:rsa|ec|pkey)[ \t](?P<options>(?:\\\r?\n|[^\n|;&]){0,600})",
    hints="openssl",
)
"""Writes a key anew; without one of the following, without a password."""
_KEEPS = regex(r"[ \t]-(?:passout|aes\w*|des\w*|camellia\w*|aria\w*|pubout|noout)\b")
_PASSED = regex(r"-passin[ \t]+[\"']?pass:(?P<value>[^\s\"']{1,100})")
_REMOTE_LOGIN = regex(
    r"\b(?:sshd|openssh-server|xrdp|x11vnc|tigervnc|vncserver)\b", hints="sshd openssh-server xrdp vnc"
)


class Password(NamedTuple):
    name: str
    """What it is, for a message."""
    value: Located
    known: bool = False
    """The same word as the user's name: everybody tries it first."""
    factory: bool = False
    """The same word as the name of the user to log in as, on another machine: what a vendor sets and documents."""
    local: bool = False
    """It opens the computer itself on which Ansible runs, or a container there."""


def in_wifi_files(files: Files) -> Iterator[Password]:
    """The passwords of Wi-Fi configuration that more than its owner can read."""
    for kind, pattern in _WIFI.items():
        for source in files.of_kind(kind):
            if source.judged and not source.template and (source.mode is None or source.mode & 0o077):
                for match in pattern.finditer(source.text):
                    yield Password(match["name"], source.located(*match.span("value")).strip_located())


def in_variables(files: Files) -> Iterator[Password]:
    """The variables of Ansible's hosts, groups and roles."""
    for source in files.of_kind("ansible-vars"):
        if source.judged and not source.text.startswith("$ANSIBLE_VAULT"):
            local = _is_of_local_hosts(source)
            for match in (match for pattern in _VARIABLES for match in pattern.finditer(source.text)):
                if not _is_comment(source.text, match.start()):
                    yield Password(match["name"], source.located(*match.span("value")), local=local)


def _is_of_local_hosts(source: Source) -> bool:
    """Whether an inventory names no host but this computer, or says that Ansible logs in nowhere."""
    nowhere = source.says(_LOGS_IN_NOWHERE)
    if not source.basename.endswith((".ini", "hosts", "inventory")):
        return nowhere
    hosts = []
    in_hosts = True
    for line in source.text.splitlines():
        words = line.split("#", 1)[0].split()
        if words and words[0].startswith("["):
            in_hosts = ":" not in line
        elif words and in_hosts:
            hosts.append(words[0])
    return (nowhere and len(hosts) < 2) or (bool(hosts) and all(_LOCAL.fullmatch(host) for host in hosts))


def given_to_programs(files: Files) -> Iterator[Password]:
    """The passwords on command lines of scripts; those that a script sets for a user are not among them."""
    yield from _matches(files.of_kind("shell-script"), _PROGRAMS)
    for source in files.of_kind("shell-script"):
        if source.judged and not source.template:
            yield from _by_variables(source)


def _by_variables(source: Source) -> Iterator[Password]:
    """The passwords that a script holds in variables of one literal value each."""
    uses = [use for pattern in (_BY_VARIABLE, _ANSWER_BY_VARIABLE) for use in pattern.finditer(source.text)]
    values = _literals(source) if uses else {}
    for use in uses:
        value = values.get(use["variable"])
        if value is not None:
            yield Password(f"The password given to {use['program']}", value)


def _literals(source: Source) -> dict[str, Located]:
    """The variables of a script that are set once, to a literal value, and that it does not ask for."""
    sets: dict[str, list[re.Match[str]]] = {}
    for match in _SET.finditer(source.text):
        sets.setdefault(match["name"], []).append(match)
    asked = {name for match in _READ.finditer(source.text) for name in _NAME.findall(match["names"])}
    found: dict[str, Located] = {}
    for name, (first, *others) in sets.items():
        value = None if others or first["more"] or name in asked else _VALUE.match(source.text, first.end())
        if value is not None:
            found[name] = source.located(*value.span("value"))
    return found


def _shed(source: Source) -> frozenset[str]:
    """The passwords of keys that a script writes anew without a password: they protect nothing."""
    options = (match["options"] for match in _SHEDS.finditer(source.text))
    return frozenset(each["value"] for text in options if not _KEEPS.search(text) for each in _PASSED.finditer(text))


def in_images(files: Files) -> Iterator[Password]:
    """The passwords on command lines of Dockerfiles; those of users where an image lets somebody log in from outside,
    so that they matter."""
    yield from _matches(files.of_kind("dockerfile"), _PROGRAMS)
    yield from _matches((each for each in files.of_kind("dockerfile") if _REMOTE_LOGIN.search(each.text)), _ACCOUNTS)


def _matches(sources: Iterable[Source], patterns: Iterable[re.Pattern[str]]) -> Iterator[Password]:
    for source in sources:
        if not source.judged or source.template:
            continue
        shed = _shed(source)
        for match in (match for pattern in patterns for match in pattern.finditer(source.text)):
            if not _is_comment(source.text, match.start()) and match["value"] not in shed:
                yield _password(source, match)


def _password(source: Source, match: re.Match[str]) -> Password:
    found = match.groupdict()
    user = found.get("user")
    program = found.get("program")
    name = f"The password of {user or 'the user'}" if program is None else f"The password given to {program}"
    value = source.located(*match.span("value"))
    login = re.search(rf"\b{re.escape(value)}@", source.line_text(value.span.line))
    return Password(name, value, value == user, program is not None and login is not None)


def _is_comment(text: str, at: int) -> bool:
    start = text.rfind("\n", 0, at) + 1
    return text[start:at].lstrip().startswith("#")
