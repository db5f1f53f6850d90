"""bringup-lint: a static configuration linter for ROS 2 robot bring-up."""

__version__ = "0.1.0"
