"""The sheet of a task of synthesis (лист синтеза)."""
