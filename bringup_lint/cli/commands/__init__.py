"""The commands with their options, one a file; what they do is in ``cli`` above."""
