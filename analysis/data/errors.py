"""The one exception of bad input: its text is one line and ends the script with exit code 2."""


class InputError(Exception):
    """Names file or study, what is wrong with it, and what is wanted."""
