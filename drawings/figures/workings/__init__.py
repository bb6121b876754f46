"""Workings beside figures: how what a plan shows is read off it, how what it is drawn from is found (выкладки)."""
