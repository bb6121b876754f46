"""Tasks of synthesis and the mechanisms that do what they ask (кинематический синтез)."""
