"""Many damped collisions of one η at a time, as `lanes` has those without damping.

    enter, stick_from_touch   where does the spring first meet the cap?        (`touching`)
    leave_touch               how does the first sliding end?                  (`block`)
    slide                     where, while the cap rises?                      (`sliding`)
    stick_from_rise, leave    where does sticking end that began there?        (`first_sticking`)
    join                      those whose first sliding ends while it falls    (`block`)
    slide, stick_from_fall, leave …                                            (`sticking`)
    stick_through_rise, …     those that did not meet the cap at first         (`first_sticking`)

A step goes in turns: `find_motion` reads √x, the cap, the velocity spent and the time at each q
from the pieces of Taylor's series, a lane after the other but these four columns at once; then a
short loop makes a step of Halley's from it, four or eight lanes at once. Three or four turns lead
from a rough guess to the root.
"""
