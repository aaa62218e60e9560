"""The generated part of the report in paper/: numbers, tables and figures, from the records alone."""
