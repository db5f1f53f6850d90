"""Files that a build or a deployment tool still fills in."""

from __future__ import annotations

import re

from bringup_lint.pattern import regex

TEMPLATE_SUFFIXES = {
    ".in": "configure",
    ".j2": "jinja",
    ".jinja": "jinja",
    ".jinja2": "jinja",
    ".em": "empy",
    ".m4": "m4",
    ".erb": "erb",
    ".tmpl": "template",
    ".tpl": "template",
    ".template": "template",
}
_SAMPLE_SUFFIXES = (".example", ".sample", ".dist", ".default")
"""What people copy without the suffix: final where nothing in it is to be filled in."""
SUFFIXES = (*TEMPLATE_SUFFIXES, *_SAMPLE_SUFFIXES)
"""The ends of names that a file loses before it is in use."""

_TO_FILL = regex(
    r"<[A-Za-z][^<>\n]{0,60}>|(?i:\byour[_-]?(?:user|name|robot|ws|workspace|home|path|package)|\bchange[_-]?me\b|/path/to/)"
)
"""What a sample has where its reader is to write something."""

_PLACEHOLDERS = (
    ("jinja", "{", regex(r"\{\{(?:(?!\{\{|\}\}).)*\}\}|\{%(?:(?!\{%|%\}).)*%\}")),
    ("configure", "@", regex(r"@[A-Za-z_][A-Za-z0-9_]*@")),
    ("empy", "@", regex(r"@\((?:(?!@\()[^)])*\)|^@\[", re.M, "@( @[")),
    ("erb", "<%", regex(r"<%(?:(?!<%|%>).)*%>")),
    ("percent", "%", regex(r"%(?:%[A-Z][A-Z0-9_]{2,80}%|[A-Z][A-Z0-9_]{2,80})%")),
    ("template", "", regex(r"__[A-Z][A-Z0-9_]*__|<[A-Z][A-Z0-9_]*>")),
)
"""Language, what is in every placeholder of it, and a placeholder: a search begins anew at each place where one could
begin, so that it must not run over the next such place."""
_CONTROL = regex(r"\{%|^@\[|<%(?!=)|^(?:ifdef|ifelse|m4_)\b|^#(?:if|else|endif)\b", re.M)


_UNFILLED = {"jinja": regex(r"\{[{%#]"), "erb": regex(r"<%")}
"""What every template of a language holds whose text is not final: what its tool would change."""
_MARK = regex(r"[{@<%]|__")
"""What every placeholder holds."""


_SHELL = regex(r"\A#![^\n]*\b(?:ba|da|z|k)?sh\b", hints="#!")
_SHELL_SUFFIXES = (".sh", ".bash", ".zsh")
_COMMENT = regex(r"^[ \t]*#[^\n]*", re.M)
_TOKEN = regex(r"@[A-Za-z_]\w*@|\{\{[ \t]*\w+[ \t]*\}\}|%{1,2}[A-Z]\w*%{1,2}")
_FILLED = regex(
    r"(?:\bs|;s)(?P<mark>[|/#,:;!~+])(?:(?!(?P=mark))[^\n]){0,40}?"
    r"(?P<token>@[A-Za-z_]\w*@|\{\{[ \t]*\w+[ \t]*\}\}|%{1,2}[A-Z]\w*%{1,2})"
)
"""A placeholder that a command of sed looks for."""
_MOST_TOKENS = 50
"""Placeholders that are looked for one by one."""
_BETWEEN_ATS = regex(r"\bs[\"']?@\w+@[^@\n]{0,200}@")
"""A command of sed with ``@`` between its parts."""
_GO = regex(
    r"\{\{-?[ \t]*(?:\.|(?:json|range|index|if|with|end|else|len|printf?|println|join)\b)(?:(?!\{\{|\}\}).)*\}\}"
)
"""What docker and its likes take after --format."""
_FORMATS = regex(r"\b(?:docker|podman|kubectl|crictl|nerdctl)\b")


def _of_others(name: str, text: str) -> str:
    """The text of a script without the placeholders that it fills in itself, or hands to a program, and without the
    ``@(...)`` of patterns, which no template of a script has under its final name."""
    if _suffix(name) not in _SHELL_SUFFIXES and not _SHELL.match(text):
        return text
    if not _MARK.search(text):
        return text
    text = _BETWEEN_ATS.sub("", _COMMENT.sub("", text)).replace("@(", "(")
    tokens = {match["token"] for match in _FILLED.finditer(text)}
    if len(tokens) > _MOST_TOKENS:
        text = _TOKEN.sub(lambda found: "" if found[0] in tokens else found[0], text)
    else:
        for token in tokens:
            text = text.replace(token, "")
    return _GO.sub("", text) if _FORMATS.search(text) else text


def template_language(name: str, text: str) -> str:
    """The template language of a file, from its name or the placeholders in it; empty when the text is final."""
    suffix = _suffix(name)
    named = TEMPLATE_SUFFIXES.get(suffix)
    if named is not None:
        return "" if named in _UNFILLED and not _UNFILLED[named].search(text) else named
    if suffix in _SAMPLE_SUFFIXES and (has_placeholder(text) or _TO_FILL.search(text)):
        return "template"
    text = _of_others(name, text)
    for language, mark, pattern in _PLACEHOLDERS[:-1]:
        if mark in text and pattern.search(text):
            return language
    return ""


def with_variables(text: str, language: str) -> str:
    """The text of a shell script with a variable that nothing sets for each placeholder, and blanks for statements of
    the template; offsets stay."""
    for name, mark, pattern in _PLACEHOLDERS:
        if language in (name, "template") and mark in text:
            text = pattern.sub(_variable, text)
    return text


def _variable(match: re.Match[str]) -> str:
    size = len(match[0])
    is_variable = size > len("${}") and not match[0].startswith("{%")
    return "${" + "_" * (size - len("${}")) + "}" if is_variable else " " * size


def final_name(name: str) -> str:
    """The name that the file will have once it is filled in: ``robot.service.in`` becomes ``robot.service``."""
    suffix = _suffix(name)
    return name[: -len(suffix)] if suffix in SUFFIXES else name


def is_sample(name: str) -> bool:
    """Whether a file is one that people copy without the end of its name: ``robot.service.example``."""
    return _suffix(name) in _SAMPLE_SUFFIXES


def _suffix(name: str) -> str:
    """What follows the last dot, with the dot."""
    return "".join(name.rpartition(".")[1:])


def has_placeholder(text: str) -> bool:
    """Whether some of the text is still to be filled in."""
    if not _MARK.search(text):
        return False
    return any(mark in text and pattern.search(text) for _, mark, pattern in _PLACEHOLDERS)


_WORD_TO_FILL = regex(r"[-@:+!|\"]{0,4}(?:[A-Z][A-Z0-9]*_)+(?:[A-Z][A-Z0-9]*)\"?(?:[/\s]|\Z)")


def is_to_fill(value: str) -> bool:
    """Whether a value begins with a word in capitals, which a script replaces: ``WorkingDirectory=ROVER_FOLDER``."""
    return bool(_WORD_TO_FILL.match(value))


def has_control_flow(text: str) -> bool:
    """Whether whole lines of the text may come and go."""
    return bool(_CONTROL.search(text))


_STAND_IN = regex(
    r"[<\[({].*[>\])}]|\$\{?\w+\}?|[*x•.#_-]+|.*\{\{.*\}\}.*|@\w+@|%\w+%"
    r"|(?:your|insert|enter|put|replace|change|fill|todo|fixme|redacted)[-_ ]?(?:.*[-_ ])?"
    r"(?:me|this|here|it|in|with|by|password|passphrase|passwd|psk|key|secret|token|ssid|wifi|\W)*"
    r"|placeholder|todo|none|null|n/?a",
    re.IGNORECASE | re.DOTALL,
)
_RUN_TOGETHER = regex(r"(?:[Yy]our|[Mm]y|[Ee]nter|[Ii]nsert|[Ss]ome)[A-Z][A-Za-z]{2,40}")
"""``YourNetworkPassword``: words that begin with capitals."""
_NAME_AS_VALUE = regex(
    r"(?:[A-Z][A-Z0-9]*_)+(?:PASS|PASSWD|PASSWORD|PASSPHRASE|PSK|KEY|SECRET|TOKEN|SSID|PLACEHOLDER)|.*\bTODO\b.*",
    re.DOTALL,
)
"""``HOTSPOT_PASSWORD``: a word that a script replaces."""
_TEMPLATE_NAME = regex(
    r"(?:^|[._-])(?:template|sample|example|placeholder)s?(?=[._-]|\d|$)|[.-](?:dist|tmpl|default)s?(?=$|\.)"
    r"|(?<=[a-z])(?-i:Template|Sample|Example)s?(?=[._-]|\d|$)",
    re.IGNORECASE,
)
_EXAMPLE_FOLDER = regex(r"(?:^|/)(?:examples?|docs?|documentation|samples?|demo)/", re.IGNORECASE)


def is_stand_in(value: str) -> bool:
    """Whether a value only stands in for the real one: ``<your-password>``, ``${PSK}``, ``CHANGE_ME``."""
    text = value.strip()
    if len(value) >= 200:
        return False
    return bool(_STAND_IN.fullmatch(text) or _RUN_TOGETHER.fullmatch(text) or _NAME_AS_VALUE.fullmatch(text))


def is_named_template(name: str) -> bool:
    """Whether the name of a file says that it is to be copied and filled in: ``wifi.example.env``."""
    return bool(_TEMPLATE_NAME.search(name))


def is_example(name: str) -> bool:
    """Whether a path lies in a folder of examples or documentation."""
    return bool(_EXAMPLE_FOLDER.search(name))
