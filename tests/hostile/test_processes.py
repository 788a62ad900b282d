"""Processes that are killed, told to end, or cannot start: who is left, and what is said."""

import concurrent.futures
import os
import shutil
import signal
import socket
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

from servers import LONG, serving, starting
from waiting import LIMIT_SECONDS, eventually

ROOT = Path(__file__).parents[2]


def until(holds):
    def check():
        assert holds(), "it never came about"

    eventually(check)


def events(server):
    return [event["event"] for event in server.events()]


def lives(process) -> bool:
    return process.is_running() and process.status() != psutil.STATUS_ZOMBIE


def may_bind(port) -> bool:
    with socket.socket() as listener:
        listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listener.bind(("127.0.0.1", port))
        except OSError:
            return False
    return True


@pytest.mark.verify
@pytest.mark.parametrize("when", ["starting", "ready"])
def test_workers_end_with_a_parent_that_is_killed(tmp_path, when):
    with starting(tmp_path, workers=2) as server:
        until(lambda: len(server.children()) == 2)
        if when == "ready":
            until(lambda: events(server).count("ready") == 2)
        family = psutil.Process(server.process.pid).children(recursive=True)
        server.process.kill()
        until(lambda: not any(lives(each) for each in family))
        assert may_bind(server.port)


@pytest.mark.verify
def test_a_worker_that_is_killed_while_it_starts_is_replaced_at_once(tmp_path):
    with starting(tmp_path, workers=2) as server:
        until(lambda: len(server.children()) == 2)
        victim = server.children()[0]
        os.kill(victim, signal.SIGKILL)
        until(lambda: events(server).count("ready") == 2)
        died = [e for e in server.events() if e["event"] == "a worker died, another begins"]
        assert [(event["pid"], event["signal"]) for event in died] == [(victim, signal.SIGKILL)]
        assert server.get("/readyz")[0] == 200


@pytest.mark.verify
def test_numbers_of_a_dead_worker_that_are_of_the_moment_go_with_it(tmp_path):
    """Those that only grow stay: they happened."""
    with serving(tmp_path, workers=2, most_long=1) as server:
        until(lambda: events(server).count("ready") == 2)
        with concurrent.futures.ThreadPoolExecutor(20) as pool:
            asked = [pool.submit(server.get, f"{LONG}&floor=0.{i}") for i in range(1, 21)]
            until(lambda: server.metric("restitution_computations") >= 10)
            os.kill(server.children()[0], signal.SIGKILL)
            concurrent.futures.wait(asked)
        until(lambda: events(server).count("ready") == 3)
        assert server.metric("restitution_computations") == 0
        assert server.metric(r'restitution_compute_seconds_count\{call="map"\}') >= 1


@pytest.mark.parametrize("workers", [1, pytest.param(2, marks=pytest.mark.verify)])
def test_at_the_end_everybody_gets_an_answer_or_is_told_to_ask_again(tmp_path, workers):
    with serving(tmp_path, workers=workers, most_long=1) as server:
        until(lambda: events(server).count("ready") == workers)
        upload = server.send(
            "POST /api/v1/collisions HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
            "Content-Length: 100\r\n\r\n{"
        )
        with upload, concurrent.futures.ThreadPoolExecutor(12) as pool:
            asked = [pool.submit(server.get, f"{LONG}&floor=0.{i}") for i in range(1, 13)]
            until(lambda: server.metric("restitution_computations") >= 2 * workers)
            server.process.terminate()
            found = [future.result() for future in asked]
            assert upload.recv(100).startswith(b"HTTP/1.1 503 ")
        server.process.wait(LIMIT_SECONDS)
        assert {status for status, _, _ in found} == {200, 503}
        for status, headers, body in found:
            if status == 503:
                assert headers["content-type"] == "application/problem+json"
                assert int(headers["retry-after"]) >= 1
                assert b"the server is being stopped; ask again" in body
        assert not [event for event in server.events() if event["level"] == "error"]
        assert "Traceback" not in server.log.read_text()


def test_work_that_does_not_end_in_time_is_called_off_and_told_so(tmp_path):
    """With no time at all for what is in flight: nobody could wait for its eight seconds."""
    with serving(tmp_path, limits={"serving.LONGEST_FAREWELL": 0}, most_long=1) as server:
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            asked = [pool.submit(server.get, f"{LONG}&floor=0.{i}") for i in (1, 2)]
            until(lambda: server.metric("restitution_computations") == 2)
            server.process.terminate()
            found = [future.result() for future in asked]
        server.process.wait(LIMIT_SECONDS)
        assert [status for status, _, _ in found] == [503, 503]
        assert all(b"the server is being stopped" in body for _, _, body in found)


@pytest.mark.verify
def test_a_server_that_is_told_to_end_while_it_starts_ends(tmp_path):
    with starting(tmp_path, workers=2) as server:
        until(lambda: len(server.children()) == 2)
        os.kill(server.children()[0], signal.SIGKILL)
        server.process.terminate()
        server.process.wait(LIMIT_SECONDS)
        assert "Traceback" not in server.log.read_text()
        assert may_bind(server.port)


@pytest.mark.verify
def test_workers_that_cannot_start_end_the_service_instead_of_being_tried_for_ever(tmp_path):
    page = tmp_path / "page"
    shutil.copytree(ROOT / "frontend", page)
    with serving(tmp_path, workers=2, frontend_directory=page) as server:
        until(lambda: events(server).count("ready") == 2)
        shutil.rmtree(page)
        os.kill(server.children()[0], signal.SIGKILL)
        assert server.process.wait(LIMIT_SECONDS) == 1
        assert "a worker failed, the service ends" in events(server)
        assert "RESTITUTION_FRONTEND_DIRECTORY must be a folder" in server.log.read_text()


WORKS_UNTIL_THE_END = """
import concurrent.futures
import restitution as rs
from restitution.api import app

def work():
    working.set_result(None)
    while True:
        pool.submit(int).result()

pool, working = concurrent.futures.ThreadPoolExecutor(), concurrent.futures.Future()
app.warm_rest = work
rs.explore()
working.result()
"""


@pytest.mark.verify
def test_a_process_may_end_while_the_service_in_it_is_being_prepared():
    """Whatever it is about when pools of threads take nothing more."""
    command = [sys.executable, "-c", WORKS_UNTIL_THE_END]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("", "")
