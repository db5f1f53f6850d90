"""Official images: what is known of an image by its name (github.com/docker-library/official-images)."""

from __future__ import annotations

from bringup_lint.facts.host.ended_releases import EndedRelease
from bringup_lint.facts.host.ended_releases import ended_releases
from bringup_lint.facts.ros import distros
from bringup_lint.pattern import regex

_LIBRARY = r"(?:docker\.io/)?(?:library/)?(?:(?:arm64v8|amd64|arm32v7)/)?"
_OF_NVIDIA = r"(?:docker\.io/)?nvidia/cuda:.*|nvcr\.io/nvidia/cuda:.*"
_OFFICIAL = regex(rf"{_LIBRARY}(?P<name>[a-z][a-z-]*):(?P<tag>[\w.-]+)")
_ROS = regex(rf"{_LIBRARY}(?:osrf/)?ros:(?P<distro>[a-z]+)(?:-[\w.-]+)?")
_UBUNTU = regex(rf"{_LIBRARY}ubuntu:(?P<release>[\w.]+)(?:-[\w.]+)?")
_RELEASES = [distros.every()[name] for name in distros.distros_since("humble") if name != "rolling"]
_SINCE_HUMBLE = "|".join(each.name for each in _RELEASES)
_OF_RELEASES = "|".join(dict.fromkeys(each.codename for each in _RELEASES))
_VARIANT = regex(
    rf"{_LIBRARY}(?:ros:(?P<distro>{_SINCE_HUMBLE})(?:-ros-core|-ros-base|-perception)?"
    rf"|osrf/ros:(?P<desktop>{_SINCE_HUMBLE})-desktop(?:-full)?)(?:-(?:{_OF_RELEASES}))?"
)
_PLAIN = regex(
    r"(?:docker\.io/|(?:library|arm64v8|arm32v7|amd64|osrf)/)*"
    r"(?:ros|ubuntu|debian|python|scratch|ros2|alpine|busybox|node|nginx)(?:[:@]|$)|(?:nvidia/cuda|balenalib/\S*ubuntu\S*)\b"
)
_ON_UBUNTU = regex(r"[.:-]ubuntu-?(?P<year>\d\d)\.?04(?!\d)")
_JETSON = regex(r"nvcr\.io/nvidia/l4t-[\w-]+:r(?P<major>\d\d)[\w.-]*")
_CODENAMES = {"18.04": "bionic", "20.04": "focal", "22.04": "jammy", "24.04": "noble"}
_OF_JETSON = {"32": "bionic", "34": "focal", "35": "focal", "36": "jammy"}
"""Release of Jetson Linux -> the Ubuntu of its images."""
_CUDA = regex(_OF_NVIDIA)
_OF_CUDA = regex(r"(?:CUDA|CUDNN|NV|NCCL|LD_|LIBRARY_)")
"""Begins the names of the variables of NVIDIA's images."""
_BARE = regex(rf"{_LIBRARY}(?:ubuntu|debian)(?:[:@].*)?")
_UNLISTED = regex(rf"{_LIBRARY}(?:ros|ubuntu|debian|python|osrf/ros2?)(?::[^@]*)?|{_OF_NVIDIA}")
_BUILD_TOOLS = (
    r"build-essential|g\+\+|gcc|make|cmake|dpkg-dev|git|ca-certificates|gnupg2?|dirmngr|lsb-release|tzdata|locales"
)
_IN_ROS = regex(
    rf"(?:{_BUILD_TOOLS})|python3(?!-pip$).*|lib.*|ros-[a-z]+-(?:ros-(?:core|base|workspace)|ament-.*|rmw-.*|rcl.*"
    r"|rosidl-.*|ros2[a-z]+|tf2.*|launch.*|.*-msgs|common-interfaces|geometry2|robot-state-publisher|rosbag2.*|urdf.*"
    r"|kdl-parser.*|fast.*|cyclonedds.*|sros2.*|pluginlib|class-loader|message-filters)"
)
"""What the images of ros-core and ros-base have; with them their many libraries."""
_IN_PYTHON = regex(rf"{_BUILD_TOOLS}|lib.*|python3.*|curl|wget|openssh-client|unzip|xz-utils|bzip2|patch|procps")
"""What the images of buildpack-deps have."""
_LARGE = regex(r"desktop|perception|simulation")
_OTHER_SYSTEM = regex(r"alpine|ubi\d|rocky|centos|windows")
_UNCHECKED = regex(
    rf"{_LIBRARY}(?:ros|ubuntu|debian|osrf/ros2?|alpine|busybox|eclipse-mosquitto|httpd|influxdb|memcached|mongo|mysql"
    r"|microros/micro-ros-agent|nginx|node|postgres|python|rabbitmq|redis|telegraf)(?:[:@].*)?"
)
"""Official images are published without a check (github.com/docker-library/faq, "healthcheck"); that of the agent of
micro-ROS too (github.com/micro-ROS/docker, micro-ROS-Agent/Dockerfile)."""
_OF_ROOT = regex(
    rf"{_LIBRARY}(?:ros|ubuntu|debian|python|osrf/ros2?)(?:[:@]|$)"
    r"|(?:docker\.io/)?(?:nvidia/cuda|dustynv/ros)(?:[:@]|$)|nvcr\.io/nvidia/(?:cuda|l4t-(?:base|cuda|jetpack))(?:[:@]|$)"
)


def ros_distro(image: str) -> str:
    """The distribution of an image of ROS; empty for other images and for tags without one (``latest``)."""
    match = _ROS.fullmatch(image)
    return match["distro"] if match is not None and match["distro"] in distros.every() else ""


def variant_of(image: str) -> str:
    """The distribution, Humble or later, of an official image of one of its variants; empty for other images."""
    match = _VARIANT.fullmatch(image)
    return (match["distro"] or match["desktop"]) if match is not None else ""


def is_plain(image: str) -> bool:
    """Whether an image holds nothing of a robot but what its tag says."""
    return _PLAIN.match(image) is not None


def ubuntu_codename(image: str) -> str:
    """The Ubuntu of an image of Ubuntu, of ROS, of CUDA or for Jetson; empty where the name does not say it."""
    jetson = _JETSON.fullmatch(image)
    if jetson is not None:
        return _OF_JETSON.get(jetson["major"], "")
    ubuntu = _UBUNTU.fullmatch(image)
    if ubuntu is not None:
        release = _CODENAMES.get(ubuntu["release"], ubuntu["release"])
        return release if release in _CODENAMES.values() else ""
    on_ubuntu = _ON_UBUNTU.search(image)
    if on_ubuntu is not None:
        return _CODENAMES.get(f"{on_ubuntu['year']}.04", "")
    distro = ros_distro(image)
    if distro and distro != "rolling":
        return distros.codename_of(distro)
    official = _OFFICIAL.fullmatch(image)
    last = official["tag"].rpartition("-")[2] if official is not None else ""
    return last if last in _CODENAMES.values() else ""


def oldest_codename(image: str) -> str:
    """The Ubuntu of an image, and of one of rolling the oldest that it may have: for what no later one has."""
    return ubuntu_codename(image) or ("noble" if ros_distro(image) == "rolling" else "")


def ended_release(image: str) -> EndedRelease | None:
    """The release of Debian or Ubuntu of an official image, where its packages are in an archive."""
    official = _OFFICIAL.fullmatch(image)
    if official is None:
        return None
    parts = official["tag"].split("-")
    for release in ended_releases():
        own = release.distribution == official["name"]
        if own and f"{parts[0]}.".startswith(f"{release.number}."):
            return release
        if (own or release.distribution == "debian") and release.codename in parts:
            return release
    return None


def has_no_package_lists(image: str) -> bool:
    """Whether an image is published without the package lists of apt."""
    return _UNLISTED.fullmatch(image) is not None


def may_have_package(image: str, package: str) -> bool:
    """Whether an image may come with a package of apt, so that installing it needs no list."""
    if _ROS.fullmatch(image):
        return (_LARGE.search(image) is not None and package.startswith("ros-")) or bool(_IN_ROS.fullmatch(package))
    if _CUDA.fullmatch(image):
        return package.startswith(("cuda", "lib")) or package == "build-essential"
    return _BARE.fullmatch(image) is None and _IN_PYTHON.fullmatch(package) is not None


def has_dash(image: str) -> bool:
    """Whether ``/bin/sh`` of an image is dash, as on Debian and Ubuntu, of which these images are made."""
    return _UNLISTED.fullmatch(image) is not None and _OTHER_SYSTEM.search(image) is None


def has_no_healthcheck(image: str) -> bool:
    """Whether an image is published without HEALTHCHECK."""
    return _UNCHECKED.fullmatch(image) is not None


def may_set(image: str, name: str) -> bool:
    """Whether an image may be published with a variable of this name; True where the image is not known."""
    if ros_distro(image):
        return name in ("ROS_DISTRO", "LANG", "LC_ALL")
    if _CUDA.fullmatch(image):
        return _OF_CUDA.match(name) is not None
    return _BARE.fullmatch(image) is None


def runs_as_root(image: str) -> bool:
    """Whether this is an official image, or one of NVIDIA's, that sets neither USER nor STOPSIGNAL."""
    return _OF_ROOT.match(image) is not None
