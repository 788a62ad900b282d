"""`make kernel`: a stale kernel is refused, what is not known stops it, the bytes are the same."""

import shutil
import subprocess
import sys
from pathlib import Path

import brotli
import pytest

from kernel import module

ROOT = Path(__file__).parents[2]
SCRIPT = Path("deploy", "make_kernel.py")
KERNEL = Path("frontend", "kernel", "kernel.wasm")
SOURCES = ("backend/restitution", "deploy/kernel", SCRIPT, KERNEL, "requirements.lock")


def run(folder: Path, *arguments: str | Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, folder / SCRIPT, *arguments],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture
def tree(tmp_path):
    """What the kernel is made of, in another folder."""
    return copied(tmp_path / "tree")


def copied(folder: Path) -> Path:
    for name in SOURCES:
        source, target = ROOT / name, folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(source, target)
    return folder


def replace(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))


def test_kernel_in_the_tree_is_that_of_its_sources(tree):
    checked = run(tree, "--check")
    assert (checked.returncode, checked.stderr) == (0, "")


@pytest.mark.parametrize(
    ("file", "old", "new"),
    [
        (
            "backend/restitution/mechanics/hertz.py",
            "CONTACT_DURATION = 3.2180654597190430846",
            "CONTACT_DURATION = 3.2180654597190430",
        ),
        ("deploy/kernel/runtime.ll", "@stack = global [65536", "@stack = global [32768"),
        ("deploy/kernel/translating.py", "ROUNDS = 2", "ROUNDS = 1"),
        ("requirements.lock", "\nnumba==", "\nnumba==0.0."),
    ],
)
def test_kernel_of_other_sources_is_refused(tree, file, old, new):
    replace(tree / file, old, new)
    checked = run(tree, "--check")
    assert checked.returncode == 1
    assert checked.stderr.startswith("kernel.wasm was made of other sources")
    assert checked.stderr.endswith("run make kernel\n")


def test_kernel_is_small_and_names_no_place_of_the_machine_that_made_it():
    content = (ROOT / KERNEL).read_bytes()
    page = content + (ROOT / KERNEL.with_suffix(".js")).read_bytes()
    # what the page may load for it
    assert len(brotli.compress(page)) <= 40_000
    assert b"/home" not in content
    assert b".py" not in content


REFUSED = """
import re
from kernel import translating
from kernel.translating import UnknownCodeError, retarget

def refuse(words, work):
    try:
        work()
    except UnknownCodeError as error:
        assert re.search(words, str(error)), error
    else:
        raise AssertionError(words)

HEAD = 'target triple = "t"\\ntarget datalayout = "d"\\n'
BODY = 'define i32 @f() {{\\n  {}\\n}}\\n'
for line, words in (
    ("call double @llvm.x86.something()", "an intrinsic of this processor"),
    ("call void asm \\"nop\\"()", "assembly"),
    ("load <4 x double>, ptr %a", "vectors of this processor"),
    ("getelementptr i8, ptr %a, i64 24", "the layout of this machine"),
):
    refuse(words, lambda: retarget("entry", "f", HEAD + BODY.format(line), "layout"))
refuse("what it is for", lambda: retarget("entry", "f", BODY.format("ret i32 0"), "layout"))
refuse("not one function", lambda: retarget("entry", "f", HEAD, "layout"))
translating.TRIED = ("0.0", (0, 0, 0))
refuse("was not tried", translating.machine)
"""


def test_code_that_nobody_has_looked_at_is_refused():
    done = subprocess.run(
        [sys.executable, "-c", REFUSED],
        cwd=ROOT / "deploy",
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def object_with(*sections: bytes) -> bytes:
    return module.MAGIC + b"".join(sections)


def test_object_with_more_than_is_known_is_refused():
    start, custom = module.section(8, b"\0"), module.section(0, module.sized(b"producers"))
    for strange in (b"\0asm\2\0\0\0", object_with(start), object_with(custom)):
        with pytest.raises(module.UnknownObjectError):
            module.sections_of(strange)
    imported = b"\1" + module.sized(b"env") + module.sized(b"fmod") + b"\0\0"
    with pytest.raises(module.UnknownObjectError, match=r"env\.fmod would be imported"):
        module.require_imports(imported, frozenset({"sin"}))
    module.require_imports(imported, frozenset({"fmod"}))


@pytest.mark.verify
def test_make_kernel_writes_the_same_bytes_in_any_folder(tmp_path):
    here, there = copied(tmp_path / "here"), copied(tmp_path / "a longer name" / "there")
    made = [run(folder, folder / "made.wasm") for folder in (here, there)]
    assert [each.returncode for each in made] == [0, 0], made
    first, second = ((folder / "made.wasm").read_bytes() for folder in (here, there))
    assert first == second
    # numba names functions otherwise in another Python
    if sys.version_info[:2] == (3, 11):
        assert first == (ROOT / KERNEL).read_bytes()
