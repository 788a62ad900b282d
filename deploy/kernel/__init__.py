"""What `make kernel` does: the kernels of `mechanics` as one WebAssembly module for the page.

`entries` says what the module can be asked. `translating` takes the code that numba makes of it
before it is optimised for this machine, and lets LLVM write an object for WebAssembly, with what
`runtime.ll` has of numba's runtime. `module` makes a module of the object, which is all that a
linker would do. `sources` tells a kernel that is stale.
"""
