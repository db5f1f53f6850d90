"""Changes of Python files that keep every blank and comment, made with libcst.

They run in the step that applies fixes, and only there is libcst imported: reading needs no more than ``ast``.
"""
