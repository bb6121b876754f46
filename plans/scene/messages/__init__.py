"""Messages: what plandraft says of a scene, one table a language; both have the same kinds and placeholders."""
