"""A real server: several processes, faults, slow clients, its end, and what it tells operators."""

import concurrent.futures
import json
import os
import re
import signal
import socket
import subprocess
import urllib.error
import urllib.request

import pytest

from servers import LONG, program, serving
from waiting import LIMIT_SECONDS, eventually

COLLISION = "/api/v1/collision?kappa=18&mu_over_alpha=1.4&gt_over_gn=0.4"

TRIES = 20
"""Of what shall be seen while a long request is under way, which may be over before we look."""


@pytest.fixture(scope="module")
def single(tmp_path_factory):
    folder = tmp_path_factory.mktemp("single")
    with serving(folder, most_long=1, most_waiting=1, log_requests=True) as server:
        yield server


@pytest.fixture(scope="module")
def double(tmp_path_factory):
    settings = {"workers": 2, "root_path": "/bounce", "forwarded_allow_ips": "192.0.2.0/24"}
    with serving(tmp_path_factory.mktemp("double"), **settings) as server:
        until(lambda: [event["event"] for event in server.events()].count("ready") == 2)
        yield server


def until(holds):
    def check():
        assert holds(), "it never came about"

    eventually(check)


def test_saturation_is_told_with_the_time_to_come_again(single):
    with concurrent.futures.ThreadPoolExecutor(6) as pool:
        asked = [pool.submit(single.get, f"{LONG}&floor=0.{i}") for i in range(6)]
        found = [future.result() for future in asked]
    refused = [(headers, body) for status, headers, body in found if status == 503]
    assert sorted({status for status, _, _ in found}) == [200, 503]
    for headers, body in refused:
        assert headers["content-type"] == "application/problem+json"
        assert int(headers["retry-after"]) >= 1
        assert json.loads(body)["status"] == 503
    assert single.metric(r'restitution_requests_refused_total\{reason="saturated"\}') == len(
        refused
    )


def test_quick_requests_are_served_beside_long_ones(single):
    def overtaken(turn):
        with concurrent.futures.ThreadPoolExecutor(1) as pool:
            long = pool.submit(single.get, f"{LONG}&floor=0.9{turn}")
            until(lambda: long.done() or single.metric("restitution_computations") == 1)
            assert [single.get(COLLISION)[0] for _ in range(5)] == [200] * 5
            before = not long.done()
            assert long.result()[0] == 200
        return before

    assert any(overtaken(turn) for turn in range(TRIES))


def test_work_of_a_client_that_hangs_up_stops(single):
    computed = r'restitution_compute_seconds_count\{call="map"\}'

    def called_off(turn):
        until(lambda: single.metric("restitution_computations") == 0)
        before = single.metric(computed)
        text = f"GET {LONG}&floor=0.7{turn} HTTP/1.1\r\nHost: x\r\n\r\n"
        with single.send(text) as connection:
            until(
                lambda: (
                    single.metric("restitution_computations") == 1
                    or single.metric(computed) > before
                )
            )
            connection.close()
        until(lambda: single.metric("restitution_computations") == 0)
        return single.metric(computed) == before

    assert any(called_off(turn) for turn in range(TRIES))


def test_clients_that_send_a_byte_at_a_time_harm_nobody(single):
    heads = [single.send("G") for _ in range(50)]
    bodies = [
        single.send(
            "POST /api/v1/collisions HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
            "Content-Length: 100\r\n\r\n{"
        )
        for _ in range(50)
    ]
    for connection in (*heads, *bodies):
        connection.sendall(b" ")
    assert single.get(COLLISION)[0] == 200
    for connection in (*heads, *bodies):
        connection.close()


def test_clients_that_hang_up_in_the_middle_of_an_answer_harm_nobody(single):
    text = f"GET {LONG}&format=csv HTTP/1.1\r\nHost: x\r\n\r\n"
    with single.send(text) as connection:
        connection.recv(100)
    assert single.get(COLLISION)[0] == 200
    errors = [event for event in single.events() if event["level"] == "error"]
    assert not errors, errors[0]["exception"]


def test_requests_have_ids_that_the_log_repeats(single):
    name = "0123456789abcdef0123456789abcdef"
    assert single.get("/api/v1/presets", **{"X-Request-ID": name})[1]["x-request-id"] == name
    made = single.get("/api/v1/presets", **{"X-Request-ID": "<script>"})[1]["x-request-id"]
    assert re.fullmatch(r"[0-9a-f]{32}", made)
    until(lambda: {name, made} <= {event.get("request_id") for event in single.events()})
    logged = next(event for event in single.events() if event.get("request_id") == name)
    assert (logged["route"], logged["status"], logged["method"]) == ("/api/v1/presets", 200, "GET")


def test_log_holds_nothing_about_who_asked_or_what(single):
    single.get("/api/v1/collision?kappa=4242.5&mu_over_alpha=1&gt_over_gn=1")
    single.get("/api/v1/secret-4242.5")
    text = single.log.read_text()
    assert "4242.5" not in text
    assert "127.0.0.1" not in text.replace(single.url, "")


def test_metrics_tell_requests_time_method_and_cost_refused(single):
    single.get(f"{COLLISION}&method=coulomb")
    single.get("/api/v1/map?mu_over_alpha=1&kappa_count=100000&gt_over_gn_count=100000")
    assert single.metric(r'restitution_method_chosen_total\{method="coulomb"\}') >= 1
    assert single.metric(r'restitution_requests_refused_total\{reason="cost"\}') >= 1
    assert single.metric(r'restitution_compute_seconds_count\{call="collision"\}') >= 1
    pattern = r'http_requests_total\{handler="/api/v1/map",method="GET",status="413"\}'
    assert single.metric(pattern) >= 1


def test_garbage_is_looked_for_once_in_many_requests(single):
    eventually(single.is_prepared)
    collections = r'python_gc_collections_total\{generation="0"\}'
    before = single.metric(collections)
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        list(pool.map(single.get, [f"{COLLISION}&damping=0.{i}" for i in range(300)]))
    # with what Python sets, twenty times
    assert single.metric(collections) - before <= 5


def servers_named(server, **headers):
    return [
        each["url"] for each in json.loads(server.get("/openapi.json", **headers)[2])["servers"]
    ]


@pytest.mark.parametrize("said", ["//evil.example", "/a b", "restitution", "/", "/../..%2f"])
def test_a_path_that_cannot_be_is_not_believed(single, said):
    assert servers_named(single, **{"X-Forwarded-Prefix": said}) == ["./"]


def test_a_proxy_of_this_machine_may_say_the_path(single):
    said = {"X-Forwarded-Prefix": "/api"}
    assert servers_named(single, **said) == ["/api", "./"]
    # also where addresses of the service begin alike
    assert single.get("/api/v1/presets", **said)[0] == 200
    assert servers_named(single) == ["./"]


def test_a_proxy_of_elsewhere_may_not_and_what_was_set_holds(double):
    assert servers_named(double, **{"X-Forwarded-Prefix": "/other"}) == ["/bounce", "./"]
    assert double.get("/static/main.js")[0] == 200


def test_it_listens_at_a_socket_of_the_machine_and_takes_over_one_that_was_left(tmp_path):
    path = tmp_path / "restitution.sock"
    for is_first in (True, False):
        # short, for the name of a socket may have a hundred letters
        command = [*program(None), "serve", "--uds", path.name, "--root-path", "/bounce"]
        with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE) as process:
            try:
                assert process.stdout.readline() == b"serving restitution.sock\n"
                with socket.socket(socket.AF_UNIX) as client:
                    client.settimeout(LIMIT_SECONDS)
                    client.connect(os.path.relpath(path))
                    client.sendall(b"GET /openapi.json HTTP/1.0\r\n\r\n")
                    assert b'"url":"/bounce"' in b"".join(iter(lambda: client.recv(65536), b""))
                if is_first:
                    taken = subprocess.run(command, cwd=tmp_path, capture_output=True, check=False)
                    assert taken.returncode == 1
                    said = b"cannot listen at restitution.sock: Address already in use"
                    assert said in taken.stderr
            finally:
                process.kill()


def test_metrics_of_several_processes_are_added(double):
    before = double.metric(r'restitution_method_chosen_total\{method="pragmatic"\}')
    for _ in range(30):
        double.get(f"{COLLISION}&method=pragmatic")
    found = double.metric(r'restitution_method_chosen_total\{method="pragmatic"\}')
    assert found - before == 30


def test_a_killed_process_is_replaced_and_the_others_go_on(double):
    victim = double.children()[0]
    os.kill(victim, signal.SIGKILL)
    failures = 0
    for _ in range(20):
        try:
            assert double.get(COLLISION)[0] == 200
        except (ConnectionError, urllib.error.URLError):
            failures += 1
    # a connection that the dead process had taken may be lost, no other
    assert failures <= 1
    until(lambda: len(double.children()) == 2 and victim not in double.children())
    assert double.get("/readyz")[0] in {200, 503}


@pytest.mark.parametrize("running", ["single", "double"])
def test_stop_lets_requests_in_flight_finish(request, running):
    """The end of both servers, and so of this module."""
    server = request.getfixturevalue(running)
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        asked = pool.submit(server.get, f"{LONG}&floor=0.5")
        until(lambda: asked.done() or server.metric("restitution_computations") >= 1)
        server.process.send_signal(signal.SIGTERM)
        assert asked.result()[0] == 200
    until(lambda: server.process.poll() is not None)
    with pytest.raises((ConnectionError, urllib.error.URLError)):
        server.get("/healthz")
