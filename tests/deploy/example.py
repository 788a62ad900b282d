"""Real proxies with the examples of the deployment: they show a server below a path, with TLS."""

import os
import pwd
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import trustme
from set_up_program import program_of_machine

from servers import free_port, is_open, wait_until
from waiting import LIMIT_SECONDS

EXAMPLES = Path(__file__).parents[2] / "deploy" / "examples"

PROGRAMS = {"nginx": "nginx", "apache": "apache2", "traefik": "traefik"}
"""The proxies by the names of their examples."""

NGINX = """
pid nginx.pid;
error_log stderr crit;
events {{ }}
http {{
    access_log off;
    client_body_temp_path body;
    proxy_temp_path answers;
    fastcgi_temp_path unused;
    uwsgi_temp_path unused;
    scgi_temp_path unused;
    include {example};
}}
"""

APACHE = """
ServerRoot {folder}
DefaultRuntimeDir {folder}
PidFile apache.pid
ErrorLog error.log
Listen 127.0.0.1:{port}
{user}
"""

APACHE_MODULES = (
    *("mpm_event", "authz_core", "alias", "headers", "proxy", "proxy_http"),
    *("socache_shmcb", "ssl"),
)


@contextmanager
def behind(name: str, folder: Path, server: int) -> Iterator[str]:
    """Yield the address at which a proxy shows a server: it ends with ``/restitution``."""
    folder.mkdir(parents=True)
    port = free_port()
    trustme.CA().issue_cert("localhost").private_key_and_cert_chain_pem.write_to_path(
        folder / "dept.pem"
    )
    (example,) = EXAMPLES.glob(f"{name}.*")
    changed = {
        "dept.example;": "localhost;",
        "`dept.example`": "`localhost`",
        "ServerName dept.example": "ServerName localhost",
        "/etc/ssl/certs/dept.example.pem": str(folder / "dept.pem"),
        "/etc/ssl/private/dept.example.key": str(folder / "dept.pem"),
        "127.0.0.1:8000": f"127.0.0.1:{server}",
        "listen 443": f"listen 127.0.0.1:{port}",
        "*:443": f"127.0.0.1:{port}",
    }
    text = example.read_text()
    for old, new in changed.items():
        text = text.replace(old, new)
    copy = folder / example.name
    copy.write_text(text)
    command = COMMANDS[name](folder, port, copy)
    with (
        (folder / "log").open("wb") as log,
        subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, cwd=folder) as process,
    ):
        try:
            wait_until(lambda: is_open(port), process, folder / "log")
            yield f"https://localhost:{port}/restitution"
        finally:
            process.terminate()
            process.wait(timeout=LIMIT_SECONDS)


def program(name: str) -> str:
    found = program_of_machine(PROGRAMS[name])
    assert found, f"there is no {name}"
    return found


def _nginx(folder: Path, _: int, example: Path) -> list[str]:
    main = folder / "main.conf"
    main.write_text(NGINX.format(example=example))
    globals_ = "daemon off;" + ("user root;" if os.geteuid() == 0 else "")
    return [program("nginx"), "-p", f"{folder}/", "-c", str(main), "-g", globals_]


def _apache(folder: Path, port: int, example: Path) -> list[str]:
    # root's children become another user, who needs nothing of the folder
    user = f"User {pwd.getpwnam('nobody').pw_name}" if os.geteuid() == 0 else ""
    lines = [APACHE.format(folder=folder, port=port, user=user)]
    modules = Path("/usr/lib/apache2/modules")
    loads = [f"LoadModule {n}_module {modules}/mod_{n}.so" for n in APACHE_MODULES]
    main = folder / "main.conf"
    main.write_text("\n".join([*loads, *lines, f"Include {example}"]))
    return [program("apache"), "-f", str(main), "-D", "FOREGROUND"]


def _traefik(_: Path, port: int, example: Path) -> list[str]:
    return [
        program("traefik"),
        f"--entryPoints.websecure.address=127.0.0.1:{port}",
        f"--providers.file.filename={example}",
        "--log.level=ERROR",
        "--global.checkNewVersion=false",
    ]


COMMANDS = {"nginx": _nginx, "apache": _apache, "traefik": _traefik}
