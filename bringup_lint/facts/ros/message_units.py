"""Fields of common messages whose unit the definition gives, where another one is near at hand.

From the comments of sensor_msgs (BatteryState.msg: "Charge percentage on 0 to 1 range"; RelativeHumidity.msg;
LaserScan.msg and JointState.msg: rad) and of REP 103 for the angular velocities of Twist and Imu.
"""

from __future__ import annotations

FRACTIONS = {"sensor_msgs/msg/BatteryState": "percentage", "sensor_msgs/msg/RelativeHumidity": "relative_humidity"}
"""Message -> its field that is a share of 1."""
RADIANS = {
    "sensor_msgs/msg/LaserScan": ("angle_min", "angle_max", "angle_increment"),
    "sensor_msgs/msg/JointState": ("position", "velocity"),
    "sensor_msgs/msg/Imu": ("angular_velocity.x", "angular_velocity.y", "angular_velocity.z"),
    "geometry_msgs/msg/Twist": ("angular.x", "angular.y", "angular.z"),
}
"""Message -> its fields that are angles in rad, or speeds in rad/s."""
