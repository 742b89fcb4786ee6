"""Films of random hoops, and how often the intervals of a fit contain the truth."""
