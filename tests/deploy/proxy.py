"""A real nginx with the template of the deployment."""

import http.client
import json
import os
import re
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from set_up_program import program_of_machine

from servers import free_port, is_open, wait_until
from waiting import LIMIT_SECONDS

ROOT = Path(__file__).parents[2]
TEMPLATE = (ROOT / "deploy" / "nginx.conf.template").read_text(encoding="utf-8")
NGINX = program_of_machine("nginx")
COLLISION = "/api/v1/collision?mu_over_alpha=1.4&gt_over_gn=1.358&quantities=epsilon_t&kappa="


class Answer(NamedTuple):
    status: int
    headers: http.client.HTTPMessage
    body: bytes


class Proxy(NamedTuple):
    """An nginx that runs."""

    port: int
    folder: Path

    def ask(self, path: str, method: str = "GET", body: object = None, **headers: str) -> Answer:
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=LIMIT_SECONDS)
        try:
            named = {name.replace("_", "-"): value for name, value in headers.items()}
            connection.request(method, path, body, named)
            response = connection.getresponse()
            return Answer(response.status, response.headers, response.read())
        finally:
            connection.close()

    def collide(self, kappa: float) -> Answer:
        return self.ask(f"{COLLISION}{kappa}")

    def post(self, kappa: list[float]) -> Answer:
        body = json.dumps({"kappa": kappa, "mu_over_alpha": 1.4, "gt_over_gn": 1})
        return self.ask("/api/v1/collisions", "POST", body, Content_Type="application/json")


def filled_in(ports: list[int], listen: int, concurrency: int, limits: dict[str, str]) -> str:
    """Return the template as nginx's image fills it in, for `ports` of this machine.

    `limits` are directives whose times are others in a test, so that it depends on none.
    """
    template = TEMPLATE
    for directive, time in limits.items():
        template, found = re.subn(rf"\b{directive} \w+;", f"{directive} {time};", template)
        assert found, directive
    values = {
        "LISTEN": f"127.0.0.1:{listen}",
        "RESOLVER": "127.0.0.1",
        "SERVERS": "".join(f"server 127.0.0.1:{p} max_fails=1 fail_timeout=2s;" for p in ports),
        "CONCURRENCY": str(concurrency),
        "CONCURRENCY_PER_ADDRESS": str(concurrency),
    }
    return re.sub(r"\$\{RESTITUTION_PROXY_(\w+)\}", lambda name: values[name[1]], template)


@contextmanager
def nginx(
    folder: Path, ports: list[int], concurrency: int = 1024, **limits: str
) -> Iterator[Proxy]:
    """Run nginx before servers on `ports`."""
    port = free_port()
    folder.mkdir()
    configuration = folder / "nginx.conf"
    configuration.write_text(filled_in(ports, port, concurrency, limits))
    # root's workers would become a user who may not enter pytest's folders
    globals_ = "daemon off;" + ("user root;" if os.geteuid() == 0 else "")
    with (
        (folder / "log").open("ab") as log,
        subprocess.Popen(
            [NGINX, "-p", f"{folder}/", "-c", configuration, "-g", globals_],
            stdout=log,
            stderr=subprocess.STDOUT,
        ) as process,
    ):
        try:
            wait_until(lambda: is_open(port), process, folder / "log")
            yield Proxy(port, folder)
        finally:
            process.terminate()
            process.wait(timeout=LIMIT_SECONDS)
