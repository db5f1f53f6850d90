"""How the names of C++ files end, as GCC tells them by their names (GCC manual, "Overall Options")."""

from __future__ import annotations

CPP_SOURCES = (".cpp", ".cc", ".cxx", ".c++", ".C")
CPP_HEADERS = (".hpp", ".hh", ".h", ".hxx", ".ipp", ".tpp", ".inl")
"""Also those of files with the bodies of templates, which headers include."""
CPP = (*CPP_SOURCES, *CPP_HEADERS)
