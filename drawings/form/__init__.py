"""The form (бланк задания): the sheet of a task with all that is given on it, and nothing of its answer."""
