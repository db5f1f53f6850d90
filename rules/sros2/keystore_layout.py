"""An enclave that lacks files, or whose links lead nowhere.

## What it finds
An enclave without one of the files that the RMW opens, and links in it that lead nowhere. In a repository, which
rightly holds no keys, only enclaves with a certificate are looked at, and the key may be elsewhere.

## Why it matters on a robot
The participant cannot be created (code 117): no node of the enclave starts.

## Bad
```text
enclaves/lawn/driver/cert.pem
enclaves/lawn/driver/permissions.p7s
```

## Good
```text
enclaves/lawn/driver/cert.pem
enclaves/lawn/driver/key.pem
enclaves/lawn/driver/identity_ca.cert.pem -> ../../../public/identity_ca.cert.pem
enclaves/lawn/driver/permissions_ca.cert.pem -> ../../../public/permissions_ca.cert.pem
enclaves/lawn/driver/governance.p7s -> ../../governance.p7s
enclaves/lawn/driver/permissions.p7s
```

## References
- sros2, create_keystore and create_enclave; Cyclone DDS 0.10.5 with security
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["File could not be found, opened or is empty"])
def keystore_layout(robot: Robot):
    whole = robot.tree.complete
    for keystore in robot.sros2.keystores:
        for enclave in keystore.enclaves.values():
            where = robot.sros2.anchor(enclave.folder)
            if "/test" in f"/{where.name}" or not where.judged:
                continue
            dangling = [path.rpartition("/")[2] for path in enclave.dangling()]
            missing = [name for name in enclave.missing() if whole or name != "key.pem"]
            if dangling:
                yield finding(
                    where,
                    f"The links {', '.join(dangling)} of enclave {enclave.path} lead nowhere: code 117, its nodes do "
                    "not start",
                    advice="copy the whole keystore with its links, or put the files themselves there",
                )
            if missing and (whole or "cert.pem" in enclave.files):
                yield finding(
                    where,
                    f"Enclave {enclave.path} lacks {', '.join(missing)}: code 117, its nodes do not start",
                    advice="copy the whole keystore, or create the enclave again",
                )
