"""Clicked points of pictures: the fan that fits a wing best, and angles over time from the pictures of a film."""
