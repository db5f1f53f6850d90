"""What one or two rules ask of images and compose files. No layer imports a question."""
