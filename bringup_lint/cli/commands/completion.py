"""``bringup-lint completion SHELL``: a script that completes commands, options, values and rule names."""

from __future__ import annotations

from pathlib import Path

import click

from bringup_lint.cli.options import rules_option


@click.command(context_settings={"help_option_names": ["-h", "--help"]})
@click.argument("shell", type=click.Choice(["bash", "zsh", "fish"]))
@rules_option
def command(shell: str, rule_folders: tuple[Path, ...]) -> None:
    """Print a completion script for a shell.

    \b
    source <(bringup-lint completion bash)     # in ~/.bashrc
    source <(bringup-lint completion zsh)      # in ~/.zshrc, after compinit
    bringup-lint completion fish | source      # in ~/.config/fish/config.fish
    """
    from bringup_lint.cli.shells import SHELLS
    from bringup_lint.cli.shells import Names
    from bringup_lint.cli.syntax import commands
    from bringup_lint.registry import Registry

    click.echo(SHELLS[shell](list(commands()), Names(Registry.of(rule_folders).family_of)), nl=False)
