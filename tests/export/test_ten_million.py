"""Ten million entries on two worker processes: the same bytes, the cores busy, little memory."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

PROGRAM = Path(sys.executable).with_name("restitution")
RANGES = ["--kappa", "0.5", "30", "--psi", "0.05", "4"]

# long enough for a worker to have come to what it holds
FOUR_MILLION = ["--kappa-count", "2000", "--psi-count", "2000"]
TEN_MILLION = ["--kappa-count", "3200", "--psi-count", "3200"]
DAMPED = ["--damping", "0", "0.5", "--damping-count", "50"]
FOUR_MILLION_IN_THREE = ["--kappa-count", "284", "--psi-count", "284", *DAMPED]
TEN_MILLION_IN_THREE = ["--kappa-count", "448", "--psi-count", "448", *DAMPED]


def peak(pid):
    """Return the most memory in MB that a process has held, None if it is gone."""
    try:
        for line in Path(f"/proc/{pid}/status").read_text().splitlines():
            if line.startswith("VmHWM"):
                return int(line.split()[1]) / 1024
    except OSError:
        pass
    return None


def computed(path, counts, *, kill=False):
    """Have a table computed; return CPU of the workers and wall time in s, memory in MB."""
    command = [PROGRAM, "table", *RANGES, *counts, "--store", path, "--workers", "2"]
    begin = time.monotonic()
    processor, client, workers = {}, 0.0, 0.0
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        own = psutil.Process(process.pid)
        for line in process.stderr:
            done, _, total = line.partition(" of ")
            if not done.isdigit():
                continue
            for worker in own.children():
                if (held := peak(worker.pid)) is None or "spawn_main" not in str(worker.cmdline()):
                    continue
                workers = max(workers, held)
                times = worker.cpu_times()
                processor[worker.pid] = times.user + times.system
            client = max(client, peak(process.pid) or 0.0)
            if kill and int(done) == int(total.split()[0]) // 2:
                victim = next(iter(processor))
                psutil.Process(victim).send_signal(signal.SIGKILL)
                kill = False
        wall = time.monotonic() - begin
    assert process.returncode == 0
    assert not kill
    return sum(processor.values()), wall, workers, client


def assert_same_files(one, other):
    names = [sorted(p.relative_to(root) for p in root.rglob("*")) for root in (one, other)]
    assert names[0] == names[1]
    for name in names[0]:
        if (one / name).is_file():
            assert (one / name).read_bytes() == (other / name).read_bytes(), name


@pytest.mark.verify
@pytest.mark.parametrize(
    ("little", "counts", "runs"),
    [(FOUR_MILLION, TEN_MILLION, 3), (FOUR_MILLION_IN_THREE, TEN_MILLION_IN_THREE, 1)],
    ids=["two", "three"],
)
def test_ten_million_entries(little, counts, runs, tmp_path):
    _, _, little_workers, little_client = computed(tmp_path / "little.zarr", little)
    stores = [tmp_path / f"{run}.zarr" for run in range(runs)]
    measured = [computed(store, counts) for store in stores]
    for processor, wall, workers, client in measured:
        print(
            f"{processor:.0f} s of CPU of two workers in {wall:.0f} s: {processor / wall:.2f}; "
            f"most memory of a worker {workers:.0f} MB, of the client {client:.0f} MB"
        )
    print(f"4·10⁶ entries: worker {little_workers:.0f} MB, client {little_client:.0f} MB")
    killed = tmp_path / "killed.zarr"
    computed(killed, counts, kill=True)
    for store in [*stores[1:], killed]:
        assert_same_files(stores[0], store)
    # 48 MB of entries would show
    for _, _, workers, client in measured:
        assert workers < little_workers + 40.0
        assert client < little_client + 40.0
