"""Shares the time of a campaign out: every target has as much as every other, however short it is.

The shares of all targets lie behind each other on one line, which is cut into as many pieces as there are processes
at a time (McNaughton's rule). So a target may be cut in two, at the end of one process's time and at the beginning of
the next one's, but no time is lost. A long campaign repeats this in rounds, so that each target has had its share
whenever it is stopped.
"""

import fractions
import math

# A target runs so many seconds at a time, if there is time enough.
LONGEST = 120
# Slices are not cut in two, for short inputs and for long ones, below so many seconds.
HALVED = 40
# A slice below so many seconds is left out: it would end before it begins.
SHORTEST = 1


def slices(targets, jobs, seconds, longest=LONGEST):
    """For each process at a time its slices one after the other: target, begin and end in seconds."""
    share = fractions.Fraction(seconds) * jobs / len(targets)
    rounds = max(math.ceil(share / fractions.Fraction(longest)), 2 if share >= HALVED else 1)
    length = fractions.Fraction(seconds) / rounds
    each = length * jobs / len(targets)
    lanes = [[] for _ in range(jobs)]
    for turn in range(rounds):
        # Another target is cut in two each time.
        order = targets[turn % len(targets):] + targets[:turn % len(targets)]
        for place, target in enumerate(order):
            at, end = place * each, (place + 1) * each
            while at < end:
                lane = at // length
                until = min(end, (lane + 1) * length)
                if until - at >= SHORTEST:
                    offset = turn * length - lane * length
                    lanes[lane].append((target, float(at + offset), float(until + offset)))
                at = until
    return lanes
