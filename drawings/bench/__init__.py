"""The bench on paper: the techniques that draw, and how a bench is printed, kept and plotted."""
