"""An involute pair on its sheet: mesh, generation by a rack, sliding, tables, what is due (эвольвентная передача)."""
