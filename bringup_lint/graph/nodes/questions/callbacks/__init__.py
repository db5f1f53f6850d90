"""What callbacks, timers, services and waits do to each other."""
