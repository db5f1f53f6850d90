"""Lifecycle nodes and their states."""
