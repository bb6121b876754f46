"""What a shown force is: a side of a polygon, an arrow on a scheme, a force on the lever (виды сил на фигуре)."""

from plans.forces.cut import CLOSING, KNOWN, PART

__all__ = ["BALANCE", "CLOSING", "KNOWN", "LAID", "LOAD", "PAIR", "PART", "PRESSING", "UNKNOWN", "WHOLE"]

# Of a polygon, beside the kinds of its sides: both parts of a reaction, or a group's inner reaction, as a diagonal.
WHOLE = "whole"
LAID = KNOWN, PART  # sides that are laid off: what moments gave is known too
# Of a scheme: a load is KNOWN; a reaction is not, nor is that of a guide, which presses on its slider.
UNKNOWN, PRESSING = "unknown", "pressing"
# Of a lever: a load, half of a couple, what the drive gives.
LOAD, PAIR, BALANCE = "load", "pair", "balance"
