"""What the Python sources of nodes do, and how they hang together with what starts them."""
