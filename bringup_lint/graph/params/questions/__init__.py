"""What one or two rules ask of parameter files. No layer imports a question."""
