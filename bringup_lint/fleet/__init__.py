"""Many robots together: each is checked and reduced to a summary, and the rules of the fleet compare the summaries."""
