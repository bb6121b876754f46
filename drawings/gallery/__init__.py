"""The gallery: mechanisms that courses use, as scenes with their sheets and reports, each to be started from."""
