"""Originals (подлинники): the sheets that a scene gives, and written sheets held against them."""
