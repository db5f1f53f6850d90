"""What one or two rules ask of what starts programs. No layer imports a question."""
