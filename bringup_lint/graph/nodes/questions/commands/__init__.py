"""Commands that are repeated, kept, or sent without a fresh reading."""
