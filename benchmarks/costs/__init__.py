"""Costs that can be trusted: counts with limits, exponents, two commits timed against each other, their history."""
