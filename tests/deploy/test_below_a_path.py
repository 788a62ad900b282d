"""Below a path of a proxy all works without a setting, for all addresses are relative."""

import http.client
import json
import re
import ssl
import urllib.parse
from collections.abc import Iterator

import pytest
from example import PROGRAMS, behind
from set_up_program import program_of_machine

from servers import Serving, serving
from waiting import LIMIT_SECONDS, eventually


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Serving]:
    with serving(tmp_path_factory.mktemp("server"), tradeoff_runs=True) as server:
        yield server


@pytest.fixture(scope="module", params=PROGRAMS)
def base(
    request: pytest.FixtureRequest, server: Serving, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[str]:
    """Where a proxy shows the server, one proxy after another."""
    if not program_of_machine(PROGRAMS[request.param]):
        pytest.skip(f"there is no {request.param}")
    folder = tmp_path_factory.mktemp("proxy") / request.param
    with behind(request.param, folder, server.port) as address:
        yield address


# without the machine's certificates, which take longer to read than the answer
TRUSTING = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
TRUSTING.check_hostname, TRUSTING.verify_mode = False, ssl.CERT_NONE


def ask(address: str, method: str = "GET") -> tuple[int, http.client.HTTPMessage, bytes]:
    """Return an answer as it is, without following it elsewhere."""
    parts = urllib.parse.urlsplit(address)
    connection = http.client.HTTPSConnection(
        "localhost", parts.port, timeout=LIMIT_SECONDS, context=TRUSTING
    )
    try:
        connection.request(method, f"{parts.path}?{parts.query}")
        answer = connection.getresponse()
        return answer.status, answer.headers, answer.read()
    finally:
        connection.close()


def test_without_its_slash_the_path_leads_to_it(base: str):
    status, headers, _ = ask(base)
    assert status == 301
    assert urllib.parse.urljoin(base, headers["location"]) in (f"{base}/", f"{base}/?")


def test_the_guide_is_found_without_its_slash(base: str):
    status, headers, _ = ask(f"{base}/guide")
    assert status == 307
    assert urllib.parse.urljoin(f"{base}/guide", headers["location"]) == f"{base}/guide/"


@pytest.mark.parametrize("path", ["", "docs", "redoc"])
def test_what_a_page_names_is_there(base: str, path: str):
    _, _, body = ask(f"{base}/{path}")
    named = re.findall(r'(?:href|src|url)(?:="|: \')([^"\'#]+)["\']', body.decode())
    files = {urllib.parse.urljoin(f"{base}/{path}", name) for name in named}
    # which is there only once it is made
    files -= {f"{base}/guide/"}
    assert len(files) >= 3
    for file in files:
        assert file.startswith(f"{base}/"), file
        status, _, body = ask(file)
        assert (status, bool(body)) == (200, True), file


def test_the_description_names_the_path(base: str):
    _, _, body = ask(f"{base}/openapi.json")
    servers = [each["url"] for each in json.loads(body)["servers"]]
    assert servers == ["/restitution", "./"]


def test_a_measurement_is_found_where_its_start_says(base: str):
    start = f"{base}/api/v1/tradeoff/runs?scene=figure4"

    def begun() -> tuple[int, http.client.HTTPMessage, bytes]:
        answer = ask(start, "POST")
        assert answer[0] == 202, answer[2]
        return answer

    # the last one may still be ending
    _, headers, body = eventually(begun)
    where = urllib.parse.urljoin(start, headers["location"])
    assert where == f"{base}/api/v1/tradeoff/runs/{json.loads(body)['id']}"
    assert ask(where, "DELETE")[0] in (200, 204)


def test_refusals_and_compressed_answers_come_through(base: str):
    assert ask(f"{base}/api/v1/collision?kappa=-1")[0] == 422
    assert ask(f"{base}/api/v1/nothing")[0] == 404
    status, _, body = ask(f"{base}/api/v1/collision?kappa=63&mu_over_alpha=1.4&gt_over_gn=1.358")
    assert status == 200
    assert json.loads(body)["switches"] == 8
