"""The self-check of a written sheet of cams (проверка листа кулачков)."""
