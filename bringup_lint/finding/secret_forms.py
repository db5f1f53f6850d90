"""The forms in which files give passwords, keys and tokens away: one table for all that masks.

A form is a pattern whose one named group is the secret. The words are in small letters, and a file without any of them
is not searched. Patterns take linear time: what repeats is anchored, or bounded.
"""

from __future__ import annotations

import re

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex


class Form(NamedTuple):
    """One way to write a secret."""

    words: tuple[str, ...]
    """What the text holds, in small letters, wherever the form can match: one of them."""
    named: bool
    """Whether it also holds one of ``NAMES``."""
    pattern: re.Pattern[str]
    certain: bool = False
    """Whether the form itself proves the secret, so that no look at the value is needed."""
    in_code: bool = True
    """Whether it means the same in Python and C++."""
    begins: bool = False
    """Whether it begins with ``NAME``, so that it is looked for at these places alone."""


NAMES = ("pass", "psk", "secret", "token", "credential", "key", "pwd")
NAME = r"""(?:(?<!no)pass(?:word|wd|phrase|wort|code)|(?<![a-z])pass|(?<![a-z])pwd|psk|secret|token
    |(?<!set)(?<!import)(?<!load)credential
    |(?:api|access|auth|private|secret|encryption|signing|shared|account|master|license|wpa|service)[_-]?key
    |wep[_-]?key\d?)"""
"""How a name ends that means a secret."""
_BARE = r"""(?:\\[ "'$]|[^\s"'\\])*"""
_HEAD = r"""[\w.-]{0,80}?"""
_LINE = r"[^\n]{0,300}?"
_OPTION = r"""[ \t"',]"""
"""What is before an option: a blank, or what separates the words of a list."""
_ITEM = r"\n(?:[ \t]{0,80}\#[^\n]{0,200}\n){0,4}[ \t]{0,80}-[ \t]+"
"""The next item of a YAML list, perhaps after comments."""
_GAP = rf"""["']?(?:[ \t]+|,[ \t]*|{_ITEM})["']?"""
"""What is between an option and its value: blanks, or what separates the words of a list."""
_NEXT = r"(?:,|\n)\s{0,80}(?:\#[^\n]*\n\s{0,80})?"
"""The next key of a YAML mapping, perhaps after a comment."""


def _form(words: str, pattern: str, *, certain: bool = False, in_code: bool = True, cased: bool = False) -> Form:
    flags = re.VERBOSE | re.MULTILINE | (0 if cased else re.IGNORECASE)
    return Form(
        tuple(words.split()), NAME in pattern, regex(pattern, flags), certain, in_code, pattern.startswith(NAME)
    )


_SETTINGS = (
    # name = "value", name: 'value', "name": "value", name["x"] = ..., name:="value"
    _form("", rf"""{NAME}["'\]]*[ \t]*(?::=|[:=])[ \t]*"(?P<secret>[^"\n]+)" """),
    _form("", rf"""{NAME}["'\]]*[ \t]*(?::=|[:=])[ \t]*'(?P<secret>[^'\n]+)'"""),
    _form("", rf"""{NAME}["'\]]*[ \t]*:[ \t]+(?P<secret>[^\s"'\#,}}\]][^\n\#,}}\]]*)""", in_code=False),
    _form("", rf"""{NAME}[ \t]*=[ \t]*(?P<secret>[^\s"'=]{_BARE})""", in_code=False),
    # ROS: password:=value
    _form(":=", rf"""{NAME}["']?:=(?P<secret>[^\s"'\\,;)\]}}<]+)"""),
    # Dockerfile: ENV NAME value, ARG NAME value
    _form("env arg", rf"""^[ \t]*(?:ENV|ARG)[ \t]+\w{{0,80}}?{NAME}[ \t]+(?P<secret>[^\s=][^\n]*)"""),
    # a PIN of a modem, not of a GPIO
    _form("pin", r"""(?<![a-z0-9])pin["']?[ \t]*[:=][ \t]*["']?(?P<secret>\d{4,8})(?!\w)"""),
    # passwords: {admin: value, guest: value}
    _form(
        "passwords tokens passphrases",
        r"""(?:passwords|passphrases|tokens)["']?[ \t]*:[ \t]*\{(?P<secret>[^{}\n]+)\}""",
    ),
    _form("setcredential=", r"""SetCredential=[^:\s]+:(?P<secret>[^\n]+)""", certain=True),
    # WireGuard in netplan: keys: {private: ...}
    _form("private:", r"""(?<![\w-])private:[ \t]+["']?(?P<secret>[A-Za-z0-9+/]{42,43}=)"""),
)
_PAIRS = (
    # - name: api_key\n  value: x, {{name: api_key, value: x}}, and the other order
    _form(
        "value default",
        rf"""(?<!\w)name["']?[ \t]*:[ \t]*["']?{_HEAD}{NAME}["']?[ \t]*{_NEXT}["']?(?:value|default)["']?
        [ \t]*:[ \t]*["']?(?P<secret>[^\s"',}}][^\n"',}}]*)""",
    ),
    _form(
        "value",
        rf"""(?<!\w)value["']?[ \t]*:[ \t]*["']?(?P<secret>[^\s"',}}]+)["']?[ \t]*{_NEXT}["']?name["']?
        [ \t]*:[ \t]*["']?{_HEAD}{NAME}["']?[ \t]*(?:[,}}]|$)""",
    ),
    # <name>token</name><value>x</value>, <value>x</value><name>token</name>
    _form("<value>", rf"""{NAME}[ \t]*</name>\s{{0,80}}<value>\s{{0,80}}(?P<secret>[^<\s][^<]*)"""),
    _form(
        "<value>", rf"""<value>\s{{0,80}}(?P<secret>[^<\s][^<]*)</value>\s{{0,80}}<name>{_HEAD}{NAME}[ \t]*</name>"""
    ),
    # name="token" ... value="x", and the other order
    _form(
        "value default",
        rf"""{NAME}["'](?:\s{{1,80}}(?!value|default)[\w:-]{{1,40}}=(?:"[^"<]{{0,200}}"|'[^'<]{{0,200}}')){{0,4}}
        \s{{1,80}}(?:value|default)[ \t]*=[ \t]*["'](?P<secret>[^"'<]+)""",
    ),
    _form(
        "value default",
        rf"""\b(?:value|default)[ \t]*=[ \t]*["'](?P<secret>[^"'<\n]+)["']
        (?:\s{{1,80}}(?!name\b)[\w:-]{{1,40}}=(?:"[^"<]{{0,200}}"|'[^'<]{{0,200}}')){{0,4}}
        \s{{1,80}}name=["']{_HEAD}{NAME}["']""",
    ),
    # <Password>x</Password>, <PrivateKey><![CDATA[x]]>; of more than one line only what is closed, and not the end of
    # a text in quotes, as of "usage: <name> <password>"
    _form(
        "",
        rf"""{NAME}>\s{{0,80}}(?:<!\[CDATA\[)?\s{{0,80}}(?!["')]{{1,4}}[ \t]*(?:\n|\Z))
        (?P<secret>[^<\s](?:[^<\]]{{0,4000}}(?=</|\]\])|[^<\]\n]*))""",
    ),
    # declare_parameter("token", "x"), DeclareLaunchArgument("token", default_value="x"), setenv("TOKEN", "x")
    _form("default_value", rf"""{NAME}["'][ \t]*,\s{{0,80}}default_value[ \t]*=[ \t]*["'](?P<secret>[^"'\n]+)"""),
    _form(
        "declare_parameter setenvironmentvariable setenv environ",
        rf"""(?:declare_parameter|SetEnvironmentVariable|setenv|setdefault)\(\s{{0,80}}(?:name[ \t]*=[ \t]*)?
        ["']{_HEAD}{NAME}["'],\s{{0,80}}(?:value[ \t]*=[ \t]*)?["'](?P<secret>[^"'\n]+)""",
    ),
)
_COMMANDS = (
    _form("--", rf"""(?<![\w-])--{_HEAD}{NAME}[ \t]+["']?(?P<secret>[^\s"'=-][^\s"']*)"""),
    _form("--", rf"""(?<![\w-])--{_HEAD}{NAME}["'],?\s{{1,80}}(?:-[ \t]+)?["']?(?P<secret>[^\s"'-][^\s"']*)["']?"""),
    _form("requirepass masterauth", rf"""--(?:requirepass|masterauth){_GAP}(?P<secret>[^\s"',-][^\s"',]*)"""),
    _form("redis-cli", rf"""\bredis-cli\s{{0,80}}-[ \t]+-a{_GAP}(?P<secret>[^\s"',-][^\s"',]*)"""),
    _form("--", rf"""(?<![\w-])--{_HEAD}{NAME}["']?[ \t]*{_ITEM}["']?(?P<secret>[^\s"'-][^\s"']*)"""),
    _form("--", rf"""(?<![\w-])--{_HEAD}{NAME}["'],["'](?P<secret>[^"'\n-][^"'\n]*)"""),
    _form(
        "curl wget",
        rf"""\b(?:curl|wget)\b{_LINE}{_OPTION}(?:-u|--user|--proxy-user)(?:{_GAP}|=?["']?)
        [^\s:"',]+:(?P<secret>[^\s"',]+)""",
    ),
    _form("mysql mariadb", rf"""\b(?:mysql|mariadb)\w*\b{_LINE}{_OPTION}(?-i:-p)["']?(?P<secret>[^\s"',=-][^\s"']*)"""),
    _form("sshpass", rf"""\bsshpass{_GAP}(?-i:-p)(?:{_GAP}|["']?)(?P<secret>[^\s"',]+)"""),
    _form("login", rf"""\blogin\b{_LINE}{_OPTION}(?-i:-p){_GAP}(?P<secret>[^\s"'-][^\s"']*)"""),
    _form(
        "mosquitto_", rf"""\bmosquitto_(?:pub|sub|rr)\b{_LINE}{_OPTION}(?-i:-P){_GAP}(?P<secret>[^\s"',-][^\s"',]*)"""
    ),
    _form("redis-cli", rf"""\bredis-cli{_LINE}{_OPTION}-a{_GAP}(?P<secret>[^\s"',-][^\s"',]*)"""),
    _form("useradd usermod", rf"""\buser(?:add|mod)\b{_LINE}[ \t](?-i:-p)[ \t]+["']?(?P<secret>[^\s"'-][^\s"']*)"""),
    _form(
        "sudo", r"""\becho[ \t]+["']?(?P<secret>[^\s"'|]+)["']?[ \t]*\|[ \t]*sudo[ \t]+(?:-\w+[ \t]+){0,4}(?-i:-\w*S)"""
    ),
    _form("sudo", r"""\bsudo[ \t]+(?-i:-\w*S)\b[^\n<]{0,200}<<<[ \t]*["']?(?P<secret>[^\s"']+)"""),
    _form(
        "chpasswd",
        r"""\b(?:echo|printf)[ \t]+(?:-\w+[ \t]+)?["']?[\w.${}-]+:(?P<secret>[^\s"'|\\]+)[^\n|]{0,20}
        \|[^\n|]{0,60}chpasswd""",
    ),
    _form("chpasswd", r"""\bchpasswd[^\n<]{0,60}<<<[ \t]*["']?[\w.-]+:(?P<secret>[^\s"']+)"""),
    _form(
        "passwd", r"""\becho[ \t]+(?:-\w+[ \t]+)?["']?(?P<secret>[^\s"'|]+)["']?[ \t]*\|[ \t]*(?:sudo[ \t]+)?passwd\b"""
    ),
    _form(
        "wpa_passphrase",
        r"""\bwpa_passphrase[ \t]+(?:"[^"\n]+"|'[^'\n]+'|[^\s"'=]+)[ \t]+["']?(?P<secret>[^\s"'>|]+)""",
    ),
    _form(
        "nmcli", rf"""\bnmcli\b{_LINE}[ \t](?:[\w-]+\.)?(?:password|psk|wep-key\d?)[ \t]+["']?(?P<secret>[^\s"']+)"""
    ),
    _form("login", r"""\blogin[ \t]+\S{1,80}[ \t]+password[ \t]+(?P<secret>\S+)"""),
)
_SCHEME = r"""(?:https?|wss?|ftps?|sftp|ssh|git|rtsps?|mqtts?|amqps?|rediss?|mysql|postgres(?:ql)?)"""
_URLS = (
    _form("://", r"""://[^/\s:@"']*:(?P<secret>[^@/\s"']+)@"""),
    _form("://", r"""://(?P<secret>(?=[\w-]{0,60}\d)[\w-]{16,100})@"""),
    # an address that was taken for a path, which has no empty parts
    _form(":/", rf"""\b{_SCHEME}:/[^/\s:@"']*:(?P<secret>[^@/\s"']+)@"""),
    _form(":/", rf"""\b{_SCHEME}:/(?P<secret>(?=[\w-]{{0,60}}\d)[\w-]{{16,100}})@"""),
    _form(
        "=",
        r"""[?&](?:sig|signature|token|access_token|auth|key|api_?key|password|secret|x-amz-signature)=
        (?P<secret>[^&\s"'<>\#]{6,})""",
    ),
    _form(
        "authorization",
        r"""authorization["']?[ \t]*[:=][ \t]*["']?(?:bearer|basic|token|apikey)[ \t]+(?P<secret>[^\s"',]+)""",
    ),
    _form("bearer", r"""\bbearer[ \t]+(?P<secret>(?=[^\s"'\d]{0,200}\d)[\w.~+/=-]{12,})"""),
)
_TOKENS = (
    _form("akia asia", r"""\b(?P<secret>(?:AKIA|ASIA)[0-9A-Z]{16})\b""", certain=True, cased=True),
    _form(
        "gh github_pat_", r"""\b(?P<secret>gh[pousr]_[A-Za-z0-9]{20,}|github_pat_\w{20,})""", certain=True, cased=True
    ),
    _form("glpat- gldt- glrt-", r"""\b(?P<secret>gl(?:pat|dt|rt)-[\w-]{20,})""", certain=True, cased=True),
    _form("xox", r"""\b(?P<secret>xox[abeoprs]-[\w-]{10,})""", certain=True, cased=True),
    _form("hooks.slack.com", r"""hooks\.slack\.com/services/(?P<secret>[\w/]{20,})""", certain=True),
    _form("aiza ya29.", r"""\b(?P<secret>AIza[\w-]{35}|ya29\.[\w-]{20,})""", certain=True, cased=True),
    _form("live", r"""\b(?P<secret>[sr]k[-_]live[-_]\w{16,})""", certain=True, cased=True),
    _form(
        "npm_ dckr_pat_ hf_ pypi-",
        r"""\b(?P<secret>(?:npm|hf)_[A-Za-z0-9]{30,}|dckr_pat_[\w-]{20,}|pypi-[\w-]{50,})""",
        certain=True,
        cased=True,
    ),
    _form("eyj", r"""\b(?P<secret>eyJ[\w-]{8,}\.eyJ[\w-]{8,}(?:\.[\w-]{0,2000})?)""", certain=True, cased=True),
    # crypt(3): what /etc/shadow holds
    _form("$", r"""(?P<secret>\$(?:1|2[aby]|5|6|7|y|gy)\$[^\s:"',]{8,})""", certain=True, cased=True),
    _form("private key", r"""-----BEGIN[ ][A-Z ]{0,40}PRIVATE[ ]KEY-----(?P<secret>[^-]+)""", certain=True, cased=True),
)
FORMS = (*_SETTINGS, *_PAIRS, *_COMMANDS, *_URLS, *_TOKENS)
WORDS = tuple(dict.fromkeys(word for form in FORMS for word in form.words))
