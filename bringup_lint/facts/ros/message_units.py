"""Fields of common messages whose unit the definition gives, where another one is near at hand.

From the comments of sensor_msgs (BatteryState.msg: "Charge percentage on 0 to 1 range"; RelativeHumidity.msg;
LaserScan.msg and JointState.msg: rad; FluidPressure.msg: Pascals; MagneticField.msg: Tesla) and of REP 103 for the
angular velocities of Twist and Imu. The units of chips are from the reference of the CircuitPython libraries
(docs.circuitpython.org/projects): ``pressure`` in hPa, ``magnetic`` in microteslas.
"""

from __future__ import annotations

from bringup_lint.named_tuple import NamedTuple

FRACTIONS = {"sensor_msgs/msg/BatteryState": "percentage", "sensor_msgs/msg/RelativeHumidity": "relative_humidity"}
"""Message -> its field that is a share of 1."""
RADIANS = {
    "sensor_msgs/msg/LaserScan": ("angle_min", "angle_max", "angle_increment"),
    "sensor_msgs/msg/JointState": ("position", "velocity"),
    "sensor_msgs/msg/Imu": ("angular_velocity.x", "angular_velocity.y", "angular_velocity.z"),
    "geometry_msgs/msg/Twist": ("angular.x", "angular.y", "angular.z"),
}
"""Message -> its fields that are angles in rad, or speeds in rad/s."""


class ChipUnit(NamedTuple):
    """A property of chips that is in another unit than the message for it."""

    fields: tuple[str, ...]
    unit: str
    """That of the message."""
    property: str
    of_chip: str
    """The unit of the property."""
    libraries: frozenset[str]
    readers: str
    """What the readers of the message take it for."""


CHIP_UNITS = {
    "sensor_msgs/msg/FluidPressure": ChipUnit(
        ("fluid_pressure",),
        "Pa",
        "pressure",
        "hPa",
        frozenset(
            "adafruit_bme280 adafruit_bmp280 adafruit_bmp3xx adafruit_bme680 adafruit_dps310 adafruit_lps2x "
            "adafruit_lps35hw adafruit_ms8607 adafruit_mprls".split()
        ),
        "a hundredth of the pressure",
    ),
    "sensor_msgs/msg/MagneticField": ChipUnit(
        ("magnetic_field.x", "magnetic_field.y", "magnetic_field.z"),
        "T",
        "magnetic",
        "µT",
        frozenset(
            "adafruit_bno055 adafruit_lis3mdl adafruit_lis2mdl adafruit_lsm303dlh_mag adafruit_mmc56x3 "
            "adafruit_icm20x".split()
        ),
        "a million times the field",
    ),
}
"""Message -> the chips whose readings need a factor."""
