"""Many undamped collisions at a time: each step of their lives for a thousand of them.

`collision.follow` is what is computed here. It goes through one collision from switch to switch,
and each of its operations waits for the one before. Here a thousand collisions, each in a lane, go
through the same step together, in loops so short that a processor takes four or eight lanes at
once:

    enter                   how does the first sliding end?             (`block`)
    slide                   where does it end?                          (`sliding`)
    stick_from_compression  where does the first sticking end?          (`first_sticking`)
    leave                   who slides to the end, who is in doubt?     (`block`)
    slide, stick_in_decompression, leave …                              (`sticking`)

Quantities and equations are those of `switching`. Roots are found otherwise: from a first guess
that was fitted, by a fixed number of Halley's steps, the last of which says how good the ones
before were. A lane leaves for `follow` if that step was long, or if rounding could have a say in
any comparison; so lanes need no word on certainty, for what stays is certain. What becomes of a
lane never depends on those beside it. `lanes.damped` has those with damping.
"""
