"""The model: values of a machine that both roads share, and no method (модель)."""
