"""What is in the messages that a node makes and reads."""
