"""Exact plane geometry and the drafting board; it knows nothing of mechanisms."""
