"""What a drawing made by hand may be out in each quantity that is read off it (точность построения от руки)."""
