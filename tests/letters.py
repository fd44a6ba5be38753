"""Settings with which the named letter is simulated in a fraction of the time."""

# longer steps than the letter's own, with stops that allow them
LONG_STEPS = {"protocol.timestep": "0.5 ms", "stops.time_constant": "2 ms"}

# Where physics is not the claim: the letter closes and opens as with its own settings, with four times the torque, and
# is released for milliseconds.
QUICK = LONG_STEPS | {
    "drive.open.value": "-12 N cm",
    "protocol.window": "20 ms",
    "protocol.least_hold": 0.0,
    "protocol.stages.0.time_limit": "50 ms",
    "protocol.stages.2.hold": "20 ms",
    "protocol.stages.3.hold": "0 s",
    "protocol.stages.4.hold": "20 ms",
}
