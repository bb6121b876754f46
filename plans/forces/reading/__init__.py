"""Reading masses and loads: their tables in a scene, and the machine that they make (чтение нагрузок)."""
