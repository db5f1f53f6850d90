"""Completion scripts for bash, zsh and fish, with the names of the rules in them."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.cli.syntax import ANY
from bringup_lint.cli.syntax import FAMILIES
from bringup_lint.cli.syntax import FILE
from bringup_lint.cli.syntax import FLAG
from bringup_lint.cli.syntax import FOLDER
from bringup_lint.cli.syntax import NAMES
from bringup_lint.cli.syntax import RULES
from bringup_lint.cli.syntax import Command
from bringup_lint.cli.syntax import Option
from bringup_lint.pattern import regex

_ZSH_SPECIAL = regex(r"([\[\]:\\])")


class Names:
    """The families and the rules."""

    def __init__(self, rules: Iterable[str]) -> None:
        self.rules = sorted(rules)
        self.families = sorted({rule.partition("/")[0] for rule in self.rules})


def bash(commands: list[Command], names: Names) -> str:
    cases = "\n".join(_bash_cases(commands))
    return f"""\
# Completion for bash 4 or newer: source <(bringup-lint completion bash)
_bringup_lint_families={shlex.quote(" ".join(names.families))}
_bringup_lint_rules={shlex.quote(" ".join(names.rules))}

_bringup_lint() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} command=check at word takes
    if [[ $current == "=" ]]; then
        current=
    elif [[ $before == "=" ]]; then
        before=${{COMP_WORDS[COMP_CWORD - 2]}}
    fi
    for ((at = 1; at < COMP_CWORD; at++)); do
        word=${{COMP_WORDS[at]}}
        [[ $word == -* ]] && continue
        [[ " {_joined(commands)} " == *" $word "* ]] && command=$word
        break
    done
    COMPREPLY=()
    local options takes= arguments=
    case $command in
{cases}
    esac
    [[ $takes ]] || takes=$arguments
    if [[ $takes == "$arguments" && $current == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$current"))
        return
    fi
    case $takes in
        {FILE}) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$current") ;;
        {FOLDER}) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
        {RULES}) COMPREPLY=($(compgen -W "$_bringup_lint_rules" -- "$current")) ;;
        {FAMILIES}) COMPREPLY=($(compgen -W "$_bringup_lint_families" -- "$current")) ;;
        {NAMES})
            local first=
            [[ $current == *,* ]] && first=${{current%,*}},
            COMPREPLY=($(compgen -P "$first" -W "$_bringup_lint_families $_bringup_lint_rules" -- "${{current##*,}}"))
            ;;
        {ANY}) ;;
        *) COMPREPLY=($(compgen -W "$takes" -- "$current")) ;;
    esac
    if [[ $command == check && COMP_CWORD -eq 1 ]]; then
        COMPREPLY+=($(compgen -W "{_joined(commands)}" -- "$current"))
    fi
}}
complete -F _bringup_lint bringup-lint
"""


def _joined(commands: Iterable[Command]) -> str:
    return " ".join(command.name for command in commands)


def _bash_cases(commands: Iterable[Command]) -> Iterator[str]:
    for command in commands:
        spellings = " ".join(spelling for option in command.options for spelling in option.spellings)
        yield f"        {command.name})"
        yield f"            options={shlex.quote(spellings)} arguments={shlex.quote(command.takes)}"
        yield "            case $before in"
        for option in command.options:
            if option.takes != FLAG:
                yield f"                {'|'.join(option.spellings)}) takes={shlex.quote(option.takes)} ;;"
        yield "            esac"
        yield "            ;;"


def zsh(commands: list[Command], names: Names) -> str:
    cases = "\n".join(_zsh_cases(commands))
    described = "\n".join(f"        {shlex.quote(f'{each.name}:{each.help}')}" for each in commands)
    return f"""\
#compdef bringup-lint
# Completion for zsh: source <(bringup-lint completion zsh), or this file as _bringup-lint in a folder of $fpath
_bringup_lint_families=({" ".join(names.families)})
_bringup_lint_rules=({" ".join(names.rules)})

_bringup_lint_names() {{
    compset -P '*,'
    compadd -- $_bringup_lint_families $_bringup_lint_rules
}}

_bringup_lint_paths() {{
    local -a commands=(
{described}
    )
    ((CURRENT == 2)) && _describe command commands
    _files
}}

_bringup_lint() {{
    local command=check word
    for word in ${{words[2,CURRENT-1]}}; do
        [[ $word == -* ]] && continue
        (( ${{${{(z):-{_joined(commands)}}}[(Ie)$word]}} )) && command=$word
        break
    done
    case $command in
{cases}
    esac
}}

if [[ $funcstack[1] == _bringup* ]]; then
    _bringup_lint "$@"
else
    compdef _bringup_lint bringup-lint
fi
"""


_ZSH_TAKES = {
    ANY: " ",
    FILE: "_files",
    FOLDER: "_files -/",
    NAMES: "_bringup_lint_names",
    RULES: "compadd -- $_bringup_lint_rules",
    FAMILIES: "compadd -- $_bringup_lint_families",
}


def _zsh_cases(commands: Iterable[Command]) -> Iterator[str]:
    for command in commands:
        arguments = "_bringup_lint_paths" if command.name == "check" else _zsh_takes(command.takes)
        skipped = "" if command.name == "check" else f"1:command:({command.name})"
        yield f"        {command.name})"
        yield "            _arguments -S \\"
        for option in command.options:
            for spelling in option.spellings:
                yield f"                {shlex.quote(_zsh_spec(spelling, option))} \\"
        if skipped:
            yield f"                {shlex.quote(skipped)} \\"
        yield f"                {shlex.quote(f'*:argument:{arguments}')}"
        yield "            ;;"


def _zsh_takes(takes: str) -> str:
    return _ZSH_TAKES.get(takes) or f"({takes})"


def _zsh_spec(spelling: str, option: Option) -> str:
    described = _ZSH_SPECIAL.sub(r"\\\1", option.help)
    if option.takes == FLAG:
        return f"*{spelling}[{described}]"
    joined = "=" if spelling.startswith("--") else "+"
    return f"*{spelling}{joined}[{described}]:value:{_zsh_takes(option.takes)}"


def fish(commands: list[Command], names: Names) -> str:
    rows = "\n".join(row for command in commands for row in _fish_rows(command, commands))
    return f"""\
# Completion for fish: bringup-lint completion fish | source
set -g __bringup_lint_families {" ".join(names.families)}
set -g __bringup_lint_rules {" ".join(names.rules)}

function __bringup_lint_names
    set -l first (commandline -ct | string replace -r -- '^--[^=]*=' '' | string match -r -- '.*,')
    for name in $__bringup_lint_families $__bringup_lint_rules
        echo "$first$name"
    end
end

complete -c bringup-lint -e
{rows}
"""


_FISH_TAKES = {
    FLAG: "",
    ANY: " -x",
    FILE: " -r -F",
    FOLDER: " -x -a '(__fish_complete_directories)'",
    NAMES: " -x -a '(__bringup_lint_names)'",
    RULES: " -x -a '$__bringup_lint_rules'",
    FAMILIES: " -x -a '$__bringup_lint_families'",
}


def _fish_rows(command: Command, commands: list[Command]) -> Iterator[str]:
    others = " ".join(each.name for each in commands if each.name != "check")
    if command.name == "check":
        when = f"not __fish_seen_subcommand_from {others}"
    else:
        when = f"__fish_seen_subcommand_from {command.name}"
        if command.takes not in (FILE, FOLDER):
            yield f"complete -c bringup-lint -n '{when}' -f"
    yield f"complete -c bringup-lint -n __fish_use_subcommand -a {command.name} -d {_fish_quoted(command.help)}"
    for option in command.options:
        flags = " ".join(f"-{'l' if each.startswith('--') else 's'} {each.lstrip('-')}" for each in option.spellings)
        takes = _FISH_TAKES.get(option.takes, f" -x -a '{option.takes}'")
        yield f"complete -c bringup-lint -n '{when}' {flags}{takes} -d {_fish_quoted(option.help)}"
    if command.takes not in (FILE, FOLDER, ANY):
        values = _FISH_TAKES.get(command.takes, f" -a '{command.takes}'").removeprefix(" -x")
        yield f"complete -c bringup-lint -n '{when}'{values}"


def _fish_quoted(text: str) -> str:
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


SHELLS: dict[str, Callable[[list[Command], Names], str]] = {"bash": bash, "zsh": zsh, "fish": fish}
