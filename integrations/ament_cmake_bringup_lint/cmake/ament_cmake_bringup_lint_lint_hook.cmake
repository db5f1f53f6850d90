# The files of a package that decide how a robot comes up. Without one of them there is nothing to check.
file(GLOB_RECURSE _bringup_files FOLLOW_SYMLINKS
  "launch/*" "config/*" "params/*" "systemd/*" "etc/*" "udev/*"
  "*.launch.py" "*.launch.xml" "*.launch.yaml" "*.service" "*.rules")
if(_bringup_files)
  message(STATUS "Added test 'bringup_lint' to check how the robot comes up")
  ament_bringup_lint()
endif()
