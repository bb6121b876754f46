"""Words: what plandraft says, by key, in one file a language (слова)."""
