"""Sheets drawn once more (подлинники): those that a scene gives, and written ones held against them."""
