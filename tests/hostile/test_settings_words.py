"""Settings and options that cannot be: each is said, with what is allowed, before any start."""

import socket
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from restitution.api.serving import listeners
from restitution.cli import main
from restitution.errors import RestitutionError
from servers import starting
from waiting import LIMIT_SECONDS, eventually

FAULTS = {
    "WORKERS": {
        "two": "must be an integer from 1 to 256, got 'two'",
        "0": "must be an integer from 1 to 256, got '0'",
        "1e9": "must be an integer from 1 to 256, got '1e9'",
        "": "must be an integer from 1 to 256, got ''",
    },
    "MOST_QUICK": {"-1": "must be an integer ≥ 1, got '-1'"},
    "MOST_LONG": {"nan": "must be an integer ≥ 1, got 'nan'"},
    "MOST_WAITING": {"1.5": "must be an integer ≥ 0, got '1.5'"},
    "ROOT_PATH": {
        text: f"must be a path as /restitution, got '{text}'"
        for text in ("restitution", "/restitution/", "//evil.example", "/a b")
    },
    "FORWARDED_ALLOW_IPS": {
        text: f"must be addresses and networks with commas between them, or *, got '{text}'"
        for text in ("proxy", "10.0.0.0/33", "", "127.0.0.1,")
    },
    "LOG_REQUESTS": {"perhaps": "must be true or false, got 'perhaps'"},
    "TRADEOFF_RUNS": {"2": "must be true or false, got '2'"},
    "FRONTEND_DIRECTORY": {"/nowhere": "must be a folder that holds index.html"},
    "WORKRES": {"2": "is no setting: perhaps RESTITUTION_WORKERS is meant"},
    "most_longs": {"2": "is no setting: perhaps RESTITUTION_MOST_LONG is meant"},
}


NOWHERE = ["--host", "nowhere.invalid"]
"""So that what is not refused ends all the same."""


def run(*arguments, **environment):
    return CliRunner(env=environment).invoke(main, arguments)


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [(name, value, words) for name, faults in FAULTS.items() for value, words in faults.items()],
)
def test_a_setting_that_cannot_be_is_told_in_a_line(name, value, words):
    done = run("serve", *NOWHERE, **{f"RESTITUTION_{name}": value})
    assert done.exit_code == 2
    (line,) = done.stderr.splitlines()
    assert f"RESTITUTION_{name.upper()} {words}" in line


def test_all_that_is_wrong_is_told_at_once():
    wrong = {f"RESTITUTION_{name}": next(iter(FAULTS[name])) for name in FAULTS}
    done = run("serve", *NOWHERE, **wrong)
    assert done.exit_code == 2
    assert len(done.stderr.splitlines()) == len(wrong)


@pytest.mark.parametrize("command", [["serve", *NOWHERE], ["warm"], ["openapi"]])
def test_every_command_that_reads_settings_tells_them(command):
    done = run(*command, RESTITUTION_WORKERS="two")
    assert (done.exit_code, done.stdout) == (2, "")
    assert "RESTITUTION_WORKERS must be" in done.stderr


@pytest.mark.parametrize("port", ["-1", "65536", "99999", "http"])
def test_a_port_that_cannot_be_is_refused(port):
    done = run("serve", *NOWHERE, "--port", port)
    assert (done.exit_code, done.stdout) == (2, "")
    assert f"{port} is not in the range" in done.stderr or f"'{port}' is not a valid" in done.stderr


@pytest.mark.parametrize("host", ["nowhere.invalid", "a..b", "192.0.2.1", "300.0.0.1"])
def test_a_host_that_is_not_here_is_refused(host):
    done = run("serve", "--host", host)
    assert (done.exit_code, done.stdout) == (1, "")
    assert f"cannot listen at {host}:8000: " in done.stderr


def test_a_port_that_somebody_has_is_refused():
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = other.getsockname()[1]
        done = run("serve", "--port", str(port))
    assert (done.exit_code, done.stdout) == (1, "")
    assert f"cannot listen at 127.0.0.1:{port}: Address already in use" in done.stderr


def test_of_two_that_begin_at_the_same_moment_one_has_the_port():
    (first,) = listeners("127.0.0.1", 0)
    with first, pytest.raises(RestitutionError, match="Address already in use"):
        listeners(*first.getsockname())


@pytest.mark.parametrize("arguments", [["--out", "/nowhere/x.json"], ["--report", "/nowhere/x.md"]])
def test_a_file_that_cannot_be_made_is_told_before_the_work(arguments):
    done = run("tradeoff", "--scene", "figure4", *arguments)
    assert done.exit_code == 2
    assert "there is no folder /nowhere" in done.stderr


def test_a_store_that_cannot_be_made_is_told():
    done = run("table", "--kappa-count", "3", "--psi-count", "3", "--store", "/proc/nowhere/x")
    assert done.exit_code == 1
    assert "Error: " in done.stderr
    assert "Traceback" not in done.output


def first_line(server):
    def check():
        lines = [n for n in server.log.read_text().splitlines() if n.startswith("serving ")]
        assert lines
        return lines[0]

    return eventually(check)


def test_a_stranger_among_the_settings_is_named_and_does_no_harm(tmp_path):
    """Docker compose has some of its own, and Kubernetes sets others for a service of this name."""
    with starting(tmp_path, service_host="10.0.0.1", port="tcp://10.0.0.1:8000") as server:
        first_line(server)
        lines = server.log.read_text().splitlines()
    does_nothing = "is no setting of the server and does nothing"
    assert f"RESTITUTION_SERVICE_HOST {does_nothing}" in lines
    assert f"RESTITUTION_PORT {does_nothing}" in lines


def test_addresses_are_told_as_a_browser_takes_them():
    program = Path(sys.executable).with_name("restitution")
    command = [program, "serve", "--host", "::1", "--port", "0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        line = process.stdout.readline()
        process.kill()
        process.wait(LIMIT_SECONDS)
    assert line.startswith("serving http://[::1]:")
    assert int(line.rpartition(":")[2]) > 0
