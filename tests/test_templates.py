"""Which files a tool still fills in."""

import pytest

from bringup_lint.templates import final_name
from bringup_lint.templates import template_language

SCRIPT = "#!/bin/bash\n"


@pytest.mark.parametrize(
    "text",
    [
        'sed "s|@PILOT@|$USER|g" helm.service.in > helm.service\n',
        "sed -e s/@PILOT@/$USER/ -e 's#{{ port }}#/dev/sonar#' helm.in\n",
        "docker ps --format '{{.Names}}\\t{{.Status}}'\n",
        'docker inspect -f "{{range .Mounts}}{{ .Source }}{{end}}" helm\n',
        "# Fills in @PILOT@.\n",
        "sed -e 's|%PILOT%|'\"$USER\"'|g;s|%PORT%|/dev/sonar|g' helm.service\n",
        "sed -i 's/helm (= @VERSION@), //' control\n",
        'sed -i "s@HELM_PILOT@${USER}@g" /etc/helm.conf\n',
        "if [[ $SIZE =~ ([0-9]+)x([0-9]+)@([0-9]+) ]]; then exit 0; fi\n",
    ],
)
def test_script_that_fills_in_others(text: str) -> None:
    assert template_language("install.sh", SCRIPT + text) == ""


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("export ROS_DOMAIN_ID={{ boat_number }}\n", "jinja"),
        ("USER_NAME=@PILOT@\n", "configure"),
        ("sed s/@PILOT@/$USER/ helm.in\nPORT=@PORT@\n", "configure"),
        ("echo '{{.Names}}'\n", "jinja"),
        ("NAME=%%BOARD%%\n", "percent"),
    ],
)
def test_script_that_is_filled_in(text: str, language: str) -> None:
    assert template_language("install.sh", SCRIPT + text) == language


def test_other_files_fill_in_nothing() -> None:
    assert template_language("helm.service", "# s/@PILOT@/x/\nUser=@PILOT@\n") == "configure"


@pytest.mark.parametrize(
    ("text", "language"),
    [
        ("User=rover\n", ""),
        ("User=__PILOT__\n", "template"),
        ("User=<your user>\n", "template"),
        ("WorkingDirectory=/path/to/ws\n", "template"),
        ("Environment=ROBOT=your_robot\n", "template"),
    ],
)
def test_sample_is_final_unless_something_is_to_be_filled_in(text: str, language: str) -> None:
    assert template_language("helm.service.example", text) == language
    assert final_name("helm.service.example") == "helm.service"


@pytest.mark.parametrize(
    ("name", "text", "language"),
    [
        ("helm.service.j2", "User=rover\n", ""),
        ("helm.service.j2", "User={{ pilot }}\n", "jinja"),
        ("helm.service.j2", "{% if pilot %}User=rover\n{% endif %}\n", "jinja"),
        ("helm.service.erb", "User=rover\n", ""),
        ("helm.service.erb", "User=<%= pilot %>\n", "erb"),
        ("helm.service.in", "User=rover\n", "configure"),
    ],
)
def test_template_that_its_tool_leaves_alone_is_final(name: str, text: str, language: str) -> None:
    assert template_language(name, text) == language
