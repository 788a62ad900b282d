"""`python -m restitution`: the command line."""

from restitution.cli import main

main()
