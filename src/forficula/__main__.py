"""`python -m forficula` is `forficula`."""

from forficula.cli import main

main()
