"""What one or two rules ask of units. No layer imports a question."""
