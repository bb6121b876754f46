"""Sheets: one file a sheet, saying which plans stand where."""
