"""What crosses the border of the package, said once; knows no HTTP."""
