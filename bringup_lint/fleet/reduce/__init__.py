"""From a robot to its summary: one module for each kind of fact."""
