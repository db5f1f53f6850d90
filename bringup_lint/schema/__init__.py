"""One engine for formats that a table describes: load the table, match names, walk what is written.

A format brings its table (``facts``), the grammar of its values and a reader that calls these functions."""
