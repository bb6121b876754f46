"""The plugin of pytest: sheets that are handed in, held to their scene in the tests of a teacher or of a CI."""
