"""Figures without marks, which a student drew in their places on our form (на бланке)."""
