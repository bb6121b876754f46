"""The self-check of workings beside figures, by the analysis (проверка выкладок)."""
