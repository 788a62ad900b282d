"""From numba's code, as it is before any optimisation for this machine, to an object of wasm32.

Whatever is not known here ends it with a sentence: another numba or LLVM may word the same code in
another way, which has to be looked at.
"""

import logging
import os
import re
import sys
import tempfile
import warnings
from pathlib import Path
from typing import Any

if "numba" in sys.modules:
    raise ImportError("numba has read its settings already")

CACHE = tempfile.TemporaryDirectory(prefix="kernel-")

# Its own optimiser would write for this very processor, and kernels that are kept would be loaded
# instead of being made.
os.environ |= {
    "NUMBA_OPT": "0",
    "NUMBA_CPU_NAME": "generic",
    "NUMBA_CPU_FEATURES": "",
    "NUMBA_LOOP_VECTORIZE": "0",
    "NUMBA_SLP_VECTORIZE": "0",
    "NUMBA_CACHE_DIR": CACHE.name,
}

import llvmlite.binding as llvm
import numba
from numba.core import codegen
from numba.core.errors import NumbaWarning

from kernel.entries import COUNT, ENTRIES, NUMBER, kernel

TRIED = ("0.68.1", (22, 1, 0))
"""The numba and the LLVM whose code was looked at and whose module was tested."""

TRIPLE = "wasm32-unknown-unknown"

FEATURES = "+bulk-memory,+mutable-globals,+nontrapping-fptoint,+sign-ext,+simd128"
"""Of WebAssembly; every browser has had them since 2023."""

MATH = frozenset({"sin", "cos", "pow", "atan2", "hypot", "exp", "log", "cbrt"})
"""What is taken from JavaScript's `Math`."""

ROUNDS = 2
"""Of optimising: what the first leaves small the second takes into its callers."""

RUNTIME = Path(__file__).with_name("runtime.ll").read_text(encoding="utf-8")

STRANGE = (
    (r"@llvm\.(?:x86|aarch64|arm)\.", "an intrinsic of this processor"),
    (r"\basm\b", "assembly"),
    (r"<\d+ x (?:double|float|i\d+)>", "vectors of this processor"),
)

OFFSET = re.compile(r"getelementptr (?:inbounds )?(?:nuw )?i8, ptr [^,]+, i64 -?\d+")
"""A place in a structure as a number of bytes, which are other ones where a pointer has four."""

NOT_IN_MODULE = ("_ZN7cpython", "@__excinfo_unwrap_args", "@cfunc.", '@"cfunc.')
"""What is only called from Python; it is dropped."""


class UnknownCodeError(Exception):
    """Something that nobody has looked at yet."""


def machine() -> Any:
    """Return LLVM's for WebAssembly."""
    if (numba.__version__, llvm.llvm_version_info) != TRIED:
        found = f"numba {numba.__version__} with LLVM {llvm.llvm_version_info}"
        raise UnknownCodeError(f"{found} was not tried: look at its code and test, then set TRIED")
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    return llvm.Target.from_triple(TRIPLE).create_target_machine(
        opt=3, features=FEATURES, reloc="static", codemodel="default"
    )


def capture() -> dict[str, tuple[str, str]]:
    """Return of each entry the name of its function and the code of all that it calls."""
    # both are about what numba keeps, which is thrown away
    warnings.simplefilter("ignore", NumbaWarning)
    logging.disable(logging.WARNING)
    code: dict[str, str] = {}
    library_class: Any = codegen.CPUCodeLibrary
    optimise_for_this_machine = library_class._optimize_final_module

    def keep(library: Any) -> None:
        code[library.name] = str(library._final_module)
        optimise_for_this_machine(library)

    library_class._optimize_final_module = keep
    found = {}
    for name, (function, arguments) in ENTRIES.items():
        compiled = kernel(function)
        # those of `*rest` are one to numba
        _, folded = compiled._compiler.fold_argument_types(arguments, {})
        compiled.compile(folded)
        result = compiled.overloads[folded]
        found[name] = result.fndesc.llvm_func_name, code[result.library.name]
    library_class._optimize_final_module = optimise_for_this_machine
    return found


def retarget(name: str, function: str, code: str, layout: str) -> str:
    """Return the code of an entry for wasm32."""
    if code.count('target triple = "') != 1 or code.count('target datalayout = "') != 1:
        raise UnknownCodeError(f"{name} does not say once what it is for")
    code = re.sub(r"(?m)^target triple = .*$", f'target triple = "{TRIPLE}"', code)
    code = re.sub(r"(?m)^target datalayout = .*$", f'target datalayout = "{layout}"', code)
    code = re.sub(r'"target-(cpu|features)"="[^"]*"', "", code)
    code = code.replace("= common ", "= weak ")
    overflow = "@llvm.smul.with.overflow.i64"
    code = re.sub(
        rf"(?m)^declare [^\n]*{re.escape(overflow)}\([^\n]*$",
        "declare { i64, i1 } @multiplied(i64, i64)",
        code,
    ).replace(overflow, "@multiplied")
    # pickled errors, with the paths of sources: the status is enough
    code = re.sub(
        r'(?m)^(@"?\.const\.picklebuf\.[^ ]+ = [^{\n]*\{[^}\n]*\}) \{.*\}',
        r"\1 zeroinitializer",
        code,
    )
    if len(re.findall(rf'(?m)^define [^\n]*@"?{re.escape(function)}"?\(', code)) != 1:
        raise UnknownCodeError(f"{name} has not one function {function}")
    for pattern, what in STRANGE:
        if re.search(pattern, code):
            raise UnknownCodeError(f"{name} has {what}")
    for body in re.findall(r"(?ms)^define [^\n]*\{.*?^\}", code):
        head = body.split("\n", 1)[0]
        if not any(mark in head for mark in NOT_IN_MODULE) and OFFSET.search(body):
            raise UnknownCodeError(f"{name} has the layout of this machine in {head[:200]}")
    return code


def wrapped(name: str) -> str:
    """Return the code of what is exported: the arguments as they are, and the status."""
    kinds = {NUMBER: "double", COUNT: "i32"}
    _, arguments = ENTRIES[name]
    given = [kinds.get(argument, "ptr") for argument in arguments]
    passed = "".join(f", {kind} %a{i}" for i, kind in enumerate(given))
    declared = "".join(f", {kind}" for kind in given)
    taken = ", ".join(f"{kind} %a{i}" for i, kind in enumerate(given))
    return f"""
declare i32 @inner.{name}(ptr, ptr{declared})
define i32 @{name}({taken}) {{
  call void @empty_arena()
  %result = alloca i64
  %error = alloca ptr
  %status = call i32 @inner.{name}(ptr %result, ptr %error{passed})
  ret i32 %status
}}"""


def link(target: Any) -> Any:
    """Return one module of all entries, of which nothing else can be called."""
    layout = str(target.target_data)
    about = f'target triple = "{TRIPLE}"\ntarget datalayout = "{layout}"\n'
    module = llvm.parse_assembly(about + RUNTIME + "".join(map(wrapped, ENTRIES)))
    for name, (function, code) in capture().items():
        part = llvm.parse_assembly(retarget(name, function, code, layout))
        part.verify()
        for each in part.functions:
            # the same of two entries is one
            if not each.is_declaration:
                each.linkage = "linkonce_odr"
        entry = part.get_function(function)
        entry.name = f"inner.{name}"
        entry.linkage = "external"
        module.link_in(part)
    for each in (*module.functions, *module.global_variables):
        if not each.is_declaration and each.name not in {*ENTRIES, "stack"}:
            each.linkage = "internal"
    return module


def optimise(module: Any, target: Any) -> None:
    """Let LLVM do for wasm32 what numba lets it do for this machine, but for a smaller module."""
    # numba's own 3 makes maps a tenth faster, traces a quarter, and the module a sixth larger
    options = llvm.create_pipeline_tuning_options(speed_level=2)
    # operations side by side made damped collisions a sixth faster and the module a fifth larger
    options.loop_vectorization, options.slp_vectorization = True, False
    builder = llvm.create_pass_builder(target, options)
    for _ in range(ROUNDS):
        builder.getModulePassManager().run(module, builder)
    module.verify()
    addresses = [v.name for v in module.global_variables if "dynamic.globals" in v.name]
    if addresses:
        raise UnknownCodeError(f"addresses of this process would be built in: {addresses}")


def emit() -> bytes:
    """Return the object."""
    target = machine()
    module = link(target)
    optimise(module, target)
    emitted: bytes = target.emit_object(module)
    return emitted
