"""How a node ends: what it still sends, what it leaves moving, and what never ends."""
