"""Files that a node opens, and servers that it is."""
