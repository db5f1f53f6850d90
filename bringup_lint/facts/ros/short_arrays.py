"""Arrays of messages that are shorter in regular operation than programs take for granted."""

from __future__ import annotations

from bringup_lint.pattern import regex

EMPTY = {
    "nav_msgs/msg/Path": ("poses",),
    "geometry_msgs/msg/PoseArray": ("poses",),
    "trajectory_msgs/msg/JointTrajectory": ("points",),
    "visualization_msgs/msg/MarkerArray": ("markers",),
    "vision_msgs/msg/Detection2DArray": ("detections",),
    "vision_msgs/msg/Detection3DArray": ("detections",),
    "vision_msgs/msg/Detection2D": ("results",),
    "apriltag_msgs/msg/AprilTagDetectionArray": ("detections",),
    "ros2_aruco_interfaces/msg/ArucoMarkers": ("poses", "marker_ids"),
    "depthai_ros_msgs/msg/SpatialDetectionArray": ("detections",),
    "yolo_msgs/msg/DetectionArray": ("detections",),
    "yolov8_msgs/msg/DetectionArray": ("detections",),
    "darknet_ros_msgs/msg/BoundingBoxes": ("bounding_boxes",),
}
"""Messages that come without elements in regular operation: nothing is seen, a path is cleared, or an
empty trajectory stops what moves."""
SEEN_WORDS = "detections|bounding_boxes|boxes|objects|obstacles|persons|people|faces|tracks|markers|marker_ids"
SEEN = regex(rf"(?:{SEEN_WORDS})\Z")
"""Names for the same in messages of the robot's own."""

JOYSTICK = "sensor_msgs/msg/Joy"
COMMON = {"buttons": 11, "axes": 6}
"""How many a gamepad surely has: an Xbox controller has 11 buttons (Linux, drivers/input/joystick/xpad.c), and
``game_controller_node`` of the package joy always sends 6 axes (SDL_CONTROLLER_AXIS_MAX)."""
