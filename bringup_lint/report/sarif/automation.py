"""What a run belongs to: a category of GitHub's code scanning, or a build of Azure Pipelines.

Advanced Security for Azure DevOps asks for the build in an identity and properties of its own (GHAzDO1019 and
GHAzDO1020 of the SARIF Multitool); the agent names it in the environment.
"""

from __future__ import annotations

import os
from typing import Any
from urllib.parse import urlsplit

CATEGORY = "bringup-lint/"
_PREFIX = "azuredevops/pipeline/build/"
_PROPERTIES = {
    "buildDefinitionId": "SYSTEM_DEFINITIONID",
    "buildDefinitionName": "BUILD_DEFINITIONNAME",
    "phaseId": "SYSTEM_PHASEID",
    "phaseName": "SYSTEM_PHASENAME",
}
_IDENTITY = ("SYSTEM_TEAMPROJECTID", "SYSTEM_DEFINITIONID", "SYSTEM_PHASEID", "BUILD_SOURCEBRANCH", "BUILD_BUILDID")


def automation_details() -> dict[str, Any]:
    """A SARIF ``runAutomationDetails``."""
    if not os.environ.get("TF_BUILD"):
        return {"id": CATEGORY}
    parts = (_organisation(), *(os.environ.get(name, "") for name in _IDENTITY))
    properties = {_PREFIX + key: os.environ.get(name, "") for key, name in _PROPERTIES.items()}
    return {"id": _PREFIX + "/".join(part.strip("/") or "unknown" for part in parts), "properties": properties}


def _organisation() -> str:
    """From ``https://dev.azure.com/NAME/`` or ``https://NAME.visualstudio.com/``."""
    address = urlsplit(os.environ.get("SYSTEM_COLLECTIONURI", ""))
    return address.path.strip("/") or (address.hostname or "").partition(".")[0]
