"""Firewall scripts (ufw, iptables), saved iptables rules and nftables files: what they let in."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.model.firewall import Firewall
from bringup_lint.model.firewall import Opening
from bringup_lint.model.shell import Command
from bringup_lint.parsers.arithmetic import evaluate
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

IPTABLES = frozenset(("iptables", "ip6tables", "iptables-legacy", "iptables-nft"))
_PORTS = regex(r"(?P<first>.+?)(?:[:-](?P<last>.+))?\Z")
_UFW_PORTS = regex(r"(?P<ports>[^/\s]+)(?:/(?P<protocol>tcp|udp))?\Z")
_SERVICES = frozenset("ssh openssh http https www ntp domain ftp smtp imap pop3 mdns samba cups telnet vnc rdp".split())
"""Names of ufw's profiles and of services(5); another profile may be one for ROS."""
_NFT_UDP = regex(
    r"(?P<protocol>udp|tcp)\s+dport\s+(?:\{(?P<set>[^{}]*)\}|(?P<one>[\w-]+))(?P<rest>[^\n;}]{0,400})\baccept\b"
)
_NFT_INPUT = regex(r"hook\s+input\b[^;]*;(?:\s*policy\s+(?P<policy>\w+)\s*;)?")
_NFT_WHOLE = regex(r"^[^\S\n]*(?:(?:iif|iifname)\s+(?!\"?lo\b)\S+|ip\s+saddr\s+\S+)\s+accept\b", re.M)
_SAVED = regex(r"^(?::(?P<chain>\S+)\s+(?P<policy>\S+)|-A\s+(?P<rule>.+))", re.M)
Variables = dict[str, str]


def parse(source: Source) -> Firewall:
    """Read what is let in. Nothing is a problem: what is not understood is left out."""
    firewall = Firewall(source)
    if source.kind == "nftables":
        _nftables(firewall)
    elif source.kind == "iptables-rules":
        for match in _SAVED.finditer(source.text):
            if match["chain"] == "INPUT":
                firewall.drops = firewall.drops or match["policy"] in ("DROP", "REJECT")
            elif match["rule"]:
                words = list(source.located(match.start(), match.end()).words())
                _iptables(firewall, words, {})
        firewall.tools.setdefault("iptables", source.located(0, min(len(source.text), 1)))
    else:
        _script(firewall)
    return firewall


def _script(firewall: Firewall) -> None:
    variables: Variables = {}
    for command in shell_commands(firewall.source):
        for assignment in command.assignments:
            name, _, value = assignment.partition("=")
            number = evaluate(value, variables)
            variables[name] = str(number) if number is not None else value
        words = _without_sudo(command)
        if not words:
            continue
        tool = words[0].rpartition("/")[2]
        if tool in IPTABLES:
            firewall.tools.setdefault("ip6tables" if tool == "ip6tables" else "iptables", words[0])
            if tool != "ip6tables":
                _iptables(firewall, list(words[1:]), variables)
        elif tool == "ufw":
            firewall.tools.setdefault("ufw", words[0])
            _ufw(firewall, list(words[1:]), variables)
        elif tool == "nft":
            firewall.tools.setdefault("nft", words[0])


def _without_sudo(command: Command) -> tuple[Located, ...]:
    words = command.words
    while words and words[0].rpartition("/")[2] in ("sudo", "exec", "env"):
        words = words[1:]
    return words


def _option(words: list[Located], *names: str) -> Located | None:
    """The word behind one of these options; negated ones (``!``) count as absent."""
    for at, word in enumerate(words[:-1]):
        if word in names and (at == 0 or words[at - 1] != "!"):
            return words[at + 1]
    return None


def _iptables(firewall: Firewall, words: list[Located], variables: Variables) -> None:
    table = _option(words, "-t", "--table")
    chain = _option(words, "-A", "-I", "--append", "--insert")
    policy = _option(words, "-P", "--policy")
    if policy == "INPUT":
        firewall.drops = firewall.drops or words[-1] in ("DROP", "REJECT")
        firewall.opens_all = firewall.opens_all or words[-1] == "ACCEPT"
    if chain != "INPUT" or table not in (None, "filter"):
        return
    firewall.first_input = firewall.first_input or chain
    target = _option(words, "-j", "--jump")
    narrowing = {word for word in words if word.startswith("-")} - {
        "-A",
        "-I",
        "-j",
        "--jump",
        "--append",
        "--insert",
    }
    if target in ("DROP", "REJECT") and not narrowing:
        firewall.drops = True
    if target != "ACCEPT":
        return
    ports = _option(words, "--dport", "--destination-port", "--dports", "--destination-ports")
    protocol = str(_option(words, "-p", "--protocol") or "")
    if ports is not None:
        for part in _parts(ports):
            firewall.openings.append(_opening(part, protocol, variables))
        return
    states = bool(narrowing & {"--state", "--ctstate"})
    interface = _option(words, "-i", "--in-interface")
    if not states and interface != "lo" and protocol in ("", "udp", "all"):
        firewall.opens_all = True


def _ufw(firewall: Firewall, words: list[Located], variables: Variables) -> None:
    if words[:1] == ["enable"] or words[:2] == ["--force", "enable"]:
        firewall.drops = True
    elif words[:1] == ["default"]:
        _ufw_default(firewall, words)
    elif {"allow", "limit"} & set(words) and "out" not in words:
        at = next(index for index, word in enumerate(words) if word in ("allow", "limit"))
        firewall.first_input = firewall.first_input or words[at]
        _ufw_rule(firewall, words[at + 1 :], variables)


def _ufw_default(firewall: Firewall, words: list[Located]) -> None:
    """``ufw default allow incoming``; without a direction it is that of incoming packets."""
    if "outgoing" in words:
        return
    if "allow" in words and ("incoming" in words or "routed" not in words):
        firewall.opens_all = True
    if {"deny", "reject"} & set(words):
        firewall.drops = True


def _ufw_rule(firewall: Firewall, words: list[Located], variables: Variables) -> None:
    """What follows ``allow`` or ``limit``: ``7400/udp``, or ``proto udp from any to any port 7400:7500``."""
    protocol, port = str(_option(words, "proto") or ""), _option(words, "port")
    simple = _UFW_PORTS.match(words[0]) if port is None and len(words) == 1 else None
    if simple is not None:
        if simple["ports"].isalpha():
            if simple["ports"].lower() not in _SERVICES:
                firewall.openings.append(Opening(words[0], "", None, None, certain=False))
            return
        port, protocol = words[0].part(0, len(simple["ports"])), simple["protocol"] or ""
    if port is None:
        firewall.opens_all = True
        return
    for part in _parts(port):
        firewall.openings.append(_opening(part, protocol, variables))


def _parts(ports: Located) -> Iterator[Located]:
    """The parts of a list of ports, separated by commas."""
    start = 0
    for part in ports.split(","):
        yield ports.part(start, start + len(part))
        start += len(part) + 1


def _opening(text: Located, protocol: str, variables: Variables) -> Opening:
    match = _PORTS.match(text)
    first = evaluate(match["first"], variables) if match else None
    last = evaluate(match["last"], variables) if match and match["last"] else first
    if first is None or last is None:
        return Opening(text, protocol, None, None, certain=False)
    return Opening(text, protocol, first, last)


def _nftables(firewall: Firewall) -> None:
    source = firewall.source
    text = re.sub(r"#[^\n]*", lambda match: " " * len(match[0]), source.text)
    firewall.tools["nft"] = source.located(0, min(len(text), 1))
    if re.search(r"\btable\s+inet\b|\btable\s+ip6\b", text):
        firewall.tools["inet"] = firewall.tools["nft"]
    chain = _NFT_INPUT.search(text)
    if chain is None:
        return
    firewall.first_input = source.span(chain.start(), chain.end())
    firewall.drops = chain["policy"] == "drop" or bool(re.search(r"^\s*(?:counter\s+)?(?:drop|reject)\b", text, re.M))
    firewall.opens_all = bool(_NFT_WHOLE.search(text))
    for match in _NFT_UDP.finditer(text):
        group = "set" if match["set"] is not None else "one"
        start = match.start(group)
        for part in re.finditer(r"[^\s,]+", match[group]):
            where = source.located(start + part.start(), start + part.end())
            firewall.openings.append(_opening(where, match["protocol"], {}))
