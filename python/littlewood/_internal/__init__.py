"""What the rooms of the package share, and users do not need."""
