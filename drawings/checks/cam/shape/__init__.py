"""The curves of a cam and the body of one that translates, on every sheet that shows them (форма кулачка)."""
