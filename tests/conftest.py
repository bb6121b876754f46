"""Settings of all tests: properties are drawn the same on every run, and no test is judged by the clock."""

from hypothesis import settings

settings.register_profile("same", derandomize=True, deadline=None)
settings.load_profile("same")
