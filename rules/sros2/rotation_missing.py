"""Nothing renews the keys that this machine signs.

## What it finds
A root file system for which all of the following is true:
- It holds the private key of the certificate authority beside the enclaves, so this machine signs for itself.
- Security is switched on.
- The certificates are valid for more than 398 more days.
- No script, unit, timer or cron job mentions `ros2 security`, `openssl` or a similar tool.

If the authority's key is on another machine, so is the rotation, and nothing is reported.

## Why it matters on a robot
sros2 creates certificates and permissions for ten years: a key that is copied once works that long, and
nobody notices.

## Bad
```text
/etc/lawn/keystore/private/ca.key.pem
/etc/lawn/keystore/enclaves/lawn/driver/cert.pem
```

## Good
```text
/etc/systemd/system/renew-keys.timer
/usr/local/sbin/renew-keys.sh: ros2 security create_permission ...
```

## When to ignore it
If the keys are renewed from outside, for example by the fleet management or by flashing a new image.

## References
- NIST SP 800-57 Part 1, section 5.3 (cryptoperiods)
- sros2, utilities: certificates for 3650 days
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

ROTATES = regex(r"ros2[\s\"',]+security|create_enclave|create_permission|openssl|certbot|step\s+ca|vault")


@rule("warning", confidence="medium", silent="the keys are valid until they expire", tags=["CWE-324"])
def rotation_missing(robot: Robot) -> Iterator[Finding]:
    if not robot.tree.complete or not robot.sros2.keystores or not robot.sros2.switched_on:
        return
    kinds = ("sros2-governance", "sros2-permissions", "sros2-key", "sros2-certificate")
    if any(source.kind not in kinds and source.says(ROTATES) for source in robot.sources):
        return
    for keystore in robot.sros2.keystores:
        keys = [key for key in robot.of_kind("sros2-key") if key.name.startswith(f"{keystore.name}/private/")]
        days = [
            (certificate.last_day - robot.today).days
            for source, certificate in robot.sros2.certificates
            if source.name.startswith(f"{keystore.name}/enclaves/")
        ]
        if keys and keys[0].judged and days and max(days) > 398:
            yield finding(
                keys[0],
                f"Nothing on this machine renews what this key signs: a stolen key works for {max(days)} more days",
                advice="sign on another machine, with a job that makes new certificates and permissions every year",
                related=[
                    note(source, "valid that long")
                    for source, certificate in robot.sros2.certificates
                    if source.name.startswith(f"{keystore.name}/enclaves/")
                    and (certificate.last_day - robot.today).days == max(days)
                ][:1],
            )
