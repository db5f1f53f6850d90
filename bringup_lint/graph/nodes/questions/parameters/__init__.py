"""Parameters that a node declares, reads and hears of."""
