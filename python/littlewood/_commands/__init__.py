"""Commands that the package adds to those of the program."""
