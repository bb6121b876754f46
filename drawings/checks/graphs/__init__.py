"""The self-check of graphs and figures by their strokes on paper: axes, poles, arrows (проверка графиков)."""
