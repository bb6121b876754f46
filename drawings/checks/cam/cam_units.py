"""The units of a follower's travel and of its derivatives (размерности)."""

from __future__ import annotations

# Units of S, S' and S'' by whether the follower rocks and whether the cam translates; "1" of what has none.
UNITS = {
    (False, False): ("m", "m/rad", "m/rad2"),
    (False, True): ("m", "1", "1/m"),
    (True, False): ("rad", "1", "1/rad"),
    (True, True): ("rad", "rad/m", "rad/m2"),
}
# Those of S' and S'' as they stand behind a number; of what has none nothing does.
BARE = {how: ("" if first == "1" else first, second) for how, (_, first, second) in UNITS.items()}
