"""Write the kernel that runs in the page, `frontend/kernel/kernel.wasm`, from `mechanics`.

`python deploy/make_kernel.py [FILE]`; the same sources, tools and Python give the same bytes.
`python deploy/make_kernel.py --check` refuses a kernel that was made of others, in a blink.
"""

import sys
from pathlib import Path

from kernel import sources
from kernel.module import module_of

KERNEL = sources.ROOT / "frontend" / "kernel" / "kernel.wasm"


def main() -> None:
    """Do what the arguments say."""
    if "--check" in sys.argv:
        sys.exit(sources.reason_to_refuse(KERNEL))
    file = Path(sys.argv[1]) if len(sys.argv) > 1 else KERNEL
    file.write_bytes(made())
    print(file.name, file.stat().st_size, "bytes")


def made() -> bytes:
    """Return the module."""
    # of this very tree, whichever is installed
    sys.path.insert(0, str(sources.ROOT / "backend"))
    # the check does without numba; `translating` has something to say to it before others load it
    from kernel import translating  # noqa: PLC0415
    from kernel.entries import ENTRIES, TOLD  # noqa: PLC0415

    told = {"made_of": sources.fingerprint(), **TOLD}
    content = module_of(translating.emit(), ENTRIES, translating.MATH, told)
    for path in (str(sources.ROOT), sys.prefix, sys.base_prefix, ".py"):
        if path.encode() in content:
            raise translating.UnknownCodeError(f"{path} stands in the module")
    return content


if __name__ == "__main__":
    main()
