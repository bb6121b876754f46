"""The self-check of what a force sheet shows beside its force plans (проверка силового листа)."""
