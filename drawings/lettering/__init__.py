"""Lettering: the alphabet, written lines, the words of sheets (шрифт и слова)."""
