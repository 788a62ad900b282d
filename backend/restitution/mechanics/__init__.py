"""Laws and motion of the contact; nothing but numpy, scipy and numba."""
