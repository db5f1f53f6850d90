"""The language server: what the command line finds, while files are edited.

``connection`` speaks the protocol, in a thread of its own; ``worker`` runs everything that reads files or asks a robot,
in the main thread, where a budget of CPU time holds. ``folder`` is one folder of the workspace with what the last run
found in it; the other modules turn that into what the protocol has names for.
"""
