"""Permissions are for a different identity than that of their enclave.

## What it finds
A permissions document in an enclave's folder in which no grant has the right subject:
- If the folder has a certificate, the subject of the certificate.
- Otherwise, the name of the enclave.

## Why it matters on a robot
The participant is rejected (code 146), even with join access control off: the node does not start. This
happens when an enclave is renamed or its folder copied.

## Bad
```xml
<!-- enclaves/lawn/driver/permissions.xml -->
<subject_name>CN=/lawn/motor</subject_name>
```

## Good
```xml
<!-- enclaves/lawn/driver/permissions.xml -->
<subject_name>CN=/lawn/driver</subject_name>
```

## When to ignore it
If the certificate is not in the tree and deliberately has another common name than the enclave, as a
certificate from a company's own authority may have.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Subject name is invalid"])
def permissions_subject_mismatch(robot: Robot) -> Iterator[Finding]:
    for permissions in robot.sros2.permissions:
        match = re.search(r"(?:^|/)enclaves(/.+)/permissions\.\w+$", permissions.source.name)
        subjects = [grant.subject for grant in permissions.grants if grant.subject is not None]
        if match is None or not subjects or not all(each.enclave for each in permissions.grants):
            continue
        certified = robot.sros2.common_name(permissions.source)
        name = certified or match[1]
        if f"CN={name}" in subjects:
            continue
        where = "its certificate is for" if certified else "its folder is"
        yield finding(
            subjects[0],
            f"'{subjects[0]}' is not the identity of this enclave ({where} {name}): code 146, the node does not start",
            advice=f"write CN={name}, and sign the document again",
            fix=fix(f"write CN={name}", (subjects[0], f"CN={name}"), safe=False) if len(subjects) == 1 else None,
        )
