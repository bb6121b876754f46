"""Files: how a file, and the files of one run together, are written whole or not at all."""
