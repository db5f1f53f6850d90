"""What is known of the rules before one of them is imported: what they say of themselves, and what they need to find
anything. A run imports the rules that can find something in its tree, and lists of rules import none."""
