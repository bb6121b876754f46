"""What the sheet of a cam to be made must show, by the analysis alone (чертёж кулачка: что должно быть)."""
