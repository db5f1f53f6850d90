"""Drivers: devices that are not there, fail or are set up wrongly."""
