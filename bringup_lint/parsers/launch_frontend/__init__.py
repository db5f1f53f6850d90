"""What XML and YAML launch files have in common: tags with attributes, and the ``$(...)`` substitutions."""
