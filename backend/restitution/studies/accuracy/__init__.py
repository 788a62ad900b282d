"""What methods cost and how far they are off."""
