"""Acceptance: sheets that are handed in, held against their scene in the tests of a teacher or of a CI (приёмка)."""
