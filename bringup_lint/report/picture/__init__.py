"""The picture of a robot: its graph with the findings. One module a format, each with ``render(document) -> str``."""
