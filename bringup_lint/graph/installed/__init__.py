"""What scripts put on the robot: the files that they write or copy, and the state that they set."""
