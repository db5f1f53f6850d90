"""What one or two rules ask of launch files. No layer imports a question."""
