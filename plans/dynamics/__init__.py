"""Motion of the machine: work, reduction, energy-mass diagram, flywheel, run-up (динамика машины)."""
