"""Dockerfiles: instructions, continued lines, here-documents and stages."""

from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.parsers.dockerfile import LAYERS
from bringup_lint.parsers.dockerfile import STAGES
from bringup_lint.parsers.dockerfile import parse
from bringup_lint.parsers.dockerfile_variables import last_user
from bringup_lint.parsers.dockerfile_variables import variables
from bringup_lint.source import Source
from bringup_lint.source import Span

ROBOT = """\
# syntax=docker/dockerfile:1
ARG DISTRO=jazzy
FROM ros:${DISTRO}-ros-base AS base
RUN --mount=type=cache,target=/var/cache/apt apt-get update && \\
    # tools
    apt-get install -y \\

      curl
USER robot
FROM base as runtime
COPY --from=base /a /b
RUN <<EOF
set -e
useradd robot
EOF
entrypoint ["/ros_entrypoint.sh"]
CMD ros2 launch base base.launch.py
"""


def read(text: str) -> Dockerfile:
    return parse(Source("Dockerfile", text, kind="dockerfile"))


def test_stages_and_their_images():
    file = read(ROBOT)
    base, runtime = file.stages
    assert (base.image, base.resolved, base.name) == ("ros:${DISTRO}-ros-base", "ros:jazzy-ros-base", "base")
    assert runtime.base is base and runtime.origin == "ros:jazzy-ros-base"
    assert runtime.last("USER").value == "robot"
    assert file.final is runtime and file.problems == []


def test_continued_lines_keep_their_places():
    run = next(read(ROBOT).stages[0].all("RUN"))
    assert run.flags == ("--mount=type=cache,target=/var/cache/apt",)
    at = run.value.index("curl")
    assert run.value.part(at, at + 4).line == 8
    assert "tools" not in run.value


def test_here_documents():
    run = next(read(ROBOT).stages[1].all("RUN"))
    assert [script.splitlines() for script in run.scripts] == [["set -e", "useradd robot"]]
    assert run.scripts[0].line == 13


def test_exec_and_shell_form():
    runtime = read(ROBOT).stages[1]
    assert runtime.last("ENTRYPOINT").exec_form == ["/ros_entrypoint.sh"]
    assert runtime.last("CMD").exec_form is None


def test_another_escape_character():
    file = read("# escape=`\nFROM a\nRUN a `\n  b\n")
    assert next(file.stages[0].all("RUN")).value.split() == ["a", "b"]


def test_what_is_no_instruction_is_told():
    assert [problem.code for problem in read("RUN x\nFROM a\nRUNN x\n").problems] == [
        "no-stage",
        "unknown-instruction",
    ]


BITS = st.sampled_from(
    [
        "FROM a AS b\n",
        "FROM b\n",
        "RUN x \\\n",
        "# c\n",
        "\n",
        "RUN <<A\n",
        "A\n",
        "ARG x=1\n",
        "CMD [",
        '"a"]\n',
    ]
)


@given(st.one_of(st.lists(BITS, max_size=12).map("".join), st.text(max_size=60)))
def test_no_text_raises_and_every_span_lies_inside(text):
    file = read(text)
    places = [problem.where for problem in file.problems]
    for stage in file.stages:
        places += [stage.image]
        list(stage.chain)
        for instruction in stage.instructions:
            places += [instruction.keyword, instruction.value, *instruction.heredocs]
            assert instruction.exec_form is None or isinstance(instruction.exec_form, list)
    for place in places:
        span = place if isinstance(place, Span) else place.span
        assert 0 <= span.start <= span.end <= len(text)


def test_variables_have_the_values_that_a_build_gives_them():
    file = read(
        "ARG DISTRO=jazzy\nFROM ros:$DISTRO AS base\nARG NAME=root\nENV PILOT=$NAME\nENV NAME=heron\n"
        "FROM base\nARG DISTRO\nARG NAME=owl\nARG OTHER\nENV SETUP=/opt/ros/$DISTRO NEXT=${OTHER:-none}\n"
    )
    base, final = file.stages
    assert variables(base) == {"NAME": "heron", "PILOT": "root"}
    assert variables(final) == {
        "DISTRO": "jazzy",
        "NAME": "heron",
        "PILOT": "root",
        "SETUP": "/opt/ros/jazzy",
        "NEXT": "none",
    }


def test_the_user_of_an_image():
    def user(text: str) -> str | None:
        stage = read(text).final
        found = last_user(stage)
        return None if found is None else str(found)

    assert user("ARG WHO=heron\nFROM ros\nARG WHO\nUSER ${WHO}:dialout\nFROM 0") is None
    assert user("FROM ros AS base\nARG WHO=heron\nUSER ${WHO}:dialout\nARG WHO=owl\nFROM base\nARG WHO=crow") == (
        "heron:dialout"
    )
    assert user("FROM ros\nUSER $WHO") == "$WHO"


def test_more_stages_than_an_image_can_have_are_not_read():
    text = "FROM ros:jazzy AS s0\n" + "".join(f"FROM s{n} AS s{n + 1}\n" for n in range(300))
    file = read(text)
    assert [problem.code for problem in file.problems] == ["too-large"]
    assert len(file.stages) == LAYERS + 1
    assert len(read("FROM $IMAGE\n" * 3_000).stages) == STAGES
