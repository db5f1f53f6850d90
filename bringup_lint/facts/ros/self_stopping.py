"""Motor controllers that stop by themselves when no command comes, by what a driver for them says.

- VESC: `timeout_msec`, 1000 ms by default (VESC firmware, `conf_general.h`: APPCONF_TIMEOUT_MSEC).
- ros_arduino_bridge: AUTO_STOP_INTERVAL, 2000 ms (ROSArduinoBridge.ino).
- Waveshare's boards that take JSON: a heartbeat of 3000 ms (ugv_base_general, `heartBeatStopTime`).
- moteus: `servo.default_timeout_s`, 0.1 s (moteus reference manual).
- Kobuki: the base stops 600 ms after the last command (kobuki_core, protocol).
"""

from __future__ import annotations

from bringup_lint.pattern import regex

SELF_STOPPING = regex(
    r"(?i:vesc|moteus|kobuki)|ros_arduino_bridge|ArduinoComms|diffdrive_arduino|[\"']T[\\]?[\"']\s{0,2}:|AUTO_STOP"
)
