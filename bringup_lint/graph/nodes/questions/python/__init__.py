"""What Python finds wrong when a line runs."""
