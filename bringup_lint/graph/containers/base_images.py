"""Official images: what is known of an image by its name (github.com/docker-library/official-images)."""

from __future__ import annotations

from bringup_lint.facts.ros import distros
from bringup_lint.pattern import regex

_LIBRARY = r"(?:docker\.io/)?(?:library/)?(?:(?:arm64v8|amd64|arm32v7)/)?"
_ROS = regex(rf"{_LIBRARY}(?:osrf/)?ros:(?P<distro>[a-z]+)(?:-[\w.-]+)?")
_UNLISTED = regex(
    rf"{_LIBRARY}(?:ros|ubuntu|debian|python|osrf/ros2?)(?::[^@]*)?"
    r"|(?:docker\.io/)?nvidia/cuda:.*|nvcr\.io/nvidia/cuda:.*"
)
_UNCHECKED = regex(rf"{_LIBRARY}(?:ros|ubuntu|debian|osrf/ros2?)(?:[:@].*)?")
_OF_ROOT = regex(
    rf"{_LIBRARY}(?:ros|ubuntu|debian|python|osrf/ros2?)(?:[:@]|$)"
    r"|(?:docker\.io/)?(?:nvidia/cuda|dustynv/ros)(?:[:@]|$)|nvcr\.io/nvidia/(?:cuda|l4t-(?:base|cuda|jetpack))(?:[:@]|$)"
)


def ros_distro(image: str) -> str:
    """The distribution of an image of ROS; empty for other images and for tags without one (``latest``)."""
    match = _ROS.fullmatch(image)
    return match["distro"] if match is not None and match["distro"] in distros.every() else ""


def has_no_package_lists(image: str) -> bool:
    """Whether an image is published without the package lists of apt."""
    return _UNLISTED.fullmatch(image) is not None


def has_no_healthcheck(image: str) -> bool:
    """Whether an image is published without HEALTHCHECK."""
    return _UNCHECKED.fullmatch(image) is not None


def runs_as_root(image: str) -> bool:
    """Whether this is an official image, or one of NVIDIA's, that sets neither USER nor STOPSIGNAL."""
    return _OF_ROOT.match(image) is not None
