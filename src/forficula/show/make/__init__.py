"""Parts to make, as figures and pages show them."""
