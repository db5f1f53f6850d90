"""From paths to sources: walking, recognising, and reading safely."""
