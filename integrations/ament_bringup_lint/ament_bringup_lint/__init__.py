"""bringup-lint as a linter of ament, for `colcon test`."""
