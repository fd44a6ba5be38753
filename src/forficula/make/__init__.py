"""Solids and sheets to make, and what is checked of them."""
