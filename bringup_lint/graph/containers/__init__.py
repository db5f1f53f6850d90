"""Compose files and images: what they start, with what, from which build, and for whom."""
