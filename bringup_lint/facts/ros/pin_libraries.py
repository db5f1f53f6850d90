"""Modules of Python that write to pins, and to buses and boards that keep what was written last."""

from __future__ import annotations

PIN_LIBRARIES = (
    *(r"smbus2?", r"board", r"busio"),
    *(
        r"RPi(?:\.GPIO)?",
        r"Jetson(?:\.GPIO)?",
        r"gpiozero",
        r"gpiod",
        r"pigpio",
        r"lgpio",
        r"wiringpi",
        r"rpi_hardware_pwm",
    ),
    *(r"(?i:adafruit_\w+)", r"(?i:pca9685\w*)", r"(?i:roboclaw\w*)", r"(?i:qwiic_\w+)", r"pysabertooth", r"odrive"),
)
"""Patterns of their names."""
