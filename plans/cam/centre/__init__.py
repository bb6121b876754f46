"""The centre of a cam: what bounds its place, and the place that makes the smallest cam (выбор центра кулачка)."""
