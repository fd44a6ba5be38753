"""Parts to make, in figures and tables."""
