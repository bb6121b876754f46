"""The difference of two sheets (сверка): a written one held line by line against the one that its scene gives."""
