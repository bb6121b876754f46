"""Forces: loads, force plans group after group, the lever, friction (силовой расчёт)."""
