"""Damped contacts: the normal motion of one η, and where in it sliding and sticking end."""
