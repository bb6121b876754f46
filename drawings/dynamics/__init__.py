"""A machine's motion on its sheet: graphs, loop, flywheel, run, report, what is due (динамика)."""
