"""What builds images: bake files and build commands."""

from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.image_build import image_name
from bringup_lint.parsers import bake
from bringup_lint.parsers import build_commands
from bringup_lint.source import Source

BAKE = """\
variable "TAG" { default = "1.2" }
target "common" {
  context = "docker"
}
target "nav" {
  inherits = ["common"]
  dockerfile = "nav.Dockerfile"
  target = "runtime"
  tags = ["robot/nav:${TAG}", "robot/nav:${OTHER}"]
}
"""


def test_targets_of_a_bake_file() -> None:
    (nav,) = bake.parse(Source("docker-bake.hcl", BAKE))
    assert nav[:4] == (("robot/nav:1.2", "robot/nav:${OTHER}"), "docker", "nav.Dockerfile", "runtime")
    assert nav.where == "nav"


def test_build_commands() -> None:
    text = (
        'NAME="robot/arm"\ndocker buildx build --platform=linux/arm64 -t $NAME:2 \\\n  --file=a/Dockerfile "$HERE/.."\n'
    )
    (arm,) = build_commands.parse(Source("build.sh", text))
    assert arm[:4] == (("robot/arm:2",), "$HERE/..", "a/Dockerfile", "")
    assert not build_commands.parse(Source("a.md", "then `docker build .` and more"))


def test_each_branch_builds_its_image() -> None:
    text = "a)\n F=a.df\n T=arm\n ;;\nb)\n F=b.df\n T=base\n ;;\nesac\ndocker build -f $F -t $T .\n"
    builds = build_commands.parse(Source("build.sh", text))
    assert [(*build.names, build.dockerfile) for build in builds] == [("arm", "a.df"), ("base", "b.df")]
    (unknown,) = build_commands.parse(Source("build.sh", f"F=c.df\n{text}"))
    assert unknown.names == ("$T",)


def test_names_of_images() -> None:
    assert image_name("docker.io/library/ros:jazzy") == ("ros", "jazzy", "")
    assert image_name("host:5000/nav").is_latest and not image_name("nav@sha256:0").is_latest


@given(st.text('tagsrevil"${}[]=\n\\- docker build', max_size=80))
def test_every_text_is_read(text: str) -> None:
    bake.parse(Source("docker-bake.hcl", text))
    build_commands.parse(Source("build.sh", f"docker build {text}"))
