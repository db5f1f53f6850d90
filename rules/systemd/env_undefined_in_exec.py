"""A variable in an Exec line that nothing defines.

## What it finds
`${NAME}` in an argument of an `Exec` line, or `$NAME` as a whole argument, when nothing defines the variable:
no `Environment=`, environment file or `PassEnvironment=` of the unit, not systemd itself, and no assignment
in the line. It is an info where the whole argument is a variable for more options, as `$DRIVER_OPTS`: without them, the
program gets none. Units of the user manager, and units with an environment file that is not in the tree, are not
checked.

## Why it matters on a robot
systemd replaces the variables before a shell sees them, and an undefined one expands to nothing: `source
/opt/ros//setup.bash` fails, and `--domain ${ID}` swallows the next argument. In a terminal, where `.bashrc`
defines the variable, the same line works.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/${ROS_DISTRO}/setup.bash && exec ros2 launch rover rover.launch.py'
```

## Good
```ini
[Service]
Environment=ROS_DISTRO=jazzy
ExecStart=/bin/bash -c 'source /opt/ros/${ROS_DISTRO}/setup.bash && exec ros2 launch rover rover.launch.py'
```

## When to ignore it
When the variable reaches the service manager another way, for example through `systemctl set-environment` or
DefaultEnvironment=, or when empty is a valid value.

## References
- systemd.service(5), "Command lines"
- systemd.exec(5), "Environment Variables Set or Propagated by the Service Manager"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

VARIABLE = regex(r"\$\$|\$\{([A-Za-z_]\w*)\}|^\$([A-Za-z_]\w*)$")
OPTIONS = regex(r"\$\w*(?:ARGS|ARGUMENTS|OPTS|OPTIONS|FLAGS)\Z")
"""A place for options that may stay empty."""
OF_SYSTEMD = regex(
    r"(?:PATH|LANG|LC_\w+|LANGUAGE|USER|LOGNAME|HOME|SHELL|INVOCATION_ID|XDG_\w+|MAINPID|MANAGERPID|SYSTEMD_\w+|TERM|NOTIFY_SOCKET"
    r"|JOURNAL_STREAM|SERVICE_RESULT|EXIT_CODE|EXIT_STATUS|PIDFILE|REMOTE_\w+|RUNTIME_DIRECTORY|STATE_DIRECTORY|LOGS_DIRECTORY"
    r"|CACHE_DIRECTORY|CONFIGURATION_DIRECTORY|CREDENTIALS_DIRECTORY|(?:WATCHDOG|MONITOR|LISTEN|TRIGGER|MEMORY_PRESSURE|FDSTORE)\w*)$"
)


@rule("error", symptoms=["Referenced but unset environment variable evaluates to an empty string"])
def env_undefined_in_exec(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.running("$"):
        environment = units.environment(unit)
        if unit.manager == "user" or not environment.complete:
            continue
        seen = set()
        for process in units.processes(unit):
            if ":" in process.prefixes or unit.is_opaque(process.line):
                continue
            for word in process.argv[1:]:
                for match in VARIABLE.finditer(word):
                    name = match[1] or match[2]
                    if name is None or name in seen or environment.get(name) or OF_SYSTEMD.match(name):
                        continue
                    if _is_set(process.line, name):
                        continue
                    seen.add(name)
                    yield finding(
                        word.part(*match.span()),
                        f"{name} is not defined: {_becomes(word, match)}",
                        advice=f"define {name} with Environment= or in an environment file, "
                        f"or write $${{{name}}} if the shell should expand it",
                        severity="info" if OPTIONS.match(word) else None,
                    )


def _is_set(line: str, name: str) -> bool:
    """Whether the shell text of a command gives the variable a value."""
    written = re.escape(name)
    return re.search(rf"\b{written}=|\b(?:for|read|select)\b[^;|&]*\b{written}\b", line) is not None


def _becomes(word: Located, match: re.Match[str]) -> str:
    start = max(word.rfind(blank, 0, match.start()) for blank in " \t\n;") + 1
    ends = [at for blank in " \t\n;" if (at := word.find(blank, match.end())) != -1]
    end = min(ends, default=len(word))
    rest = word[start : match.start()] + word[match.end() : end]
    if rest:
        return f"{word[start:end]} becomes {rest}"
    return "the program gets an empty argument" if match[1] else "the program does not get this argument"
