"""Clients that others generate from the document: complete, and understood by the service."""

import enum
import importlib
import json
import subprocess
import sys
import typing
from pathlib import Path

import pytest
from document import DOCUMENT, OPERATIONS

ROOT = Path(__file__).parents[2]
CALLED = {name: operation for name, (_, _, operation) in OPERATIONS.items()}

NO_MEASURING = {"start_run": 403, "run": 403, "cancel_run": 403}
"""Measuring anew is switched off unless an administrator allows it."""


@pytest.fixture(scope="module")
def package(tmp_path_factory):
    """The client that openapi-python-client makes, which it does without a warning."""
    folder = tmp_path_factory.mktemp("client")
    (folder / "openapi.json").write_text(json.dumps(DOCUMENT))
    (folder / "settings.yml").write_text("post_hooks: []")
    program = Path(sys.executable).with_name("openapi-python-client")
    done = subprocess.run(
        [
            *(program, "generate", "--path", folder / "openapi.json", "--meta", "none"),
            *("--config", folder / "settings.yml", "--output-path", folder / "generated"),
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    assert "arning" not in done.stdout + done.stderr
    sys.path.insert(0, str(folder))
    yield importlib.import_module("generated")
    sys.path.remove(str(folder))


def calls(package):
    """Return the modules of all operations, by name."""
    folder = Path(package.__file__).parent
    files = [file for file in folder.glob("api/*/*.py") if file.stem != "__init__"]
    return {
        # a name that Python has already gets an underscore
        file.stem.rstrip("_"): importlib.import_module(
            f"generated.api.{file.parent.name}.{file.stem}"
        )
        for file in files
    }


def arguments(operation, function):
    """Return the document's own example as what the client takes."""
    hints = typing.get_type_hints(function)
    given = {
        parameter["name"]: parameter["example"]
        for parameter in operation.get("parameters", [])
        if "example" in parameter
    }
    for name, value in given.items():
        kinds = (hints[name], *typing.get_args(hints[name]))
        [kind, *_] = [k for k in kinds if isinstance(k, enum.EnumMeta)] or [lambda v: v]
        given[name] = kind(value)
    if "requestBody" in operation:
        [content] = operation["requestBody"]["content"].values()
        given["body"] = hints["body"].from_dict(content["example"])
    if any(parameter.get("in") == "path" for parameter in operation.get("parameters", [])):
        given["name"] = "none"
    return given


def test_python_client_has_every_operation_and_reads_every_answer(package, server):
    found = calls(package)
    assert found.keys() == CALLED.keys()
    with package.Client(base_url=server) as client:
        for name, module in found.items():
            given = arguments(CALLED[name], module.sync_detailed)
            answer = module.sync_detailed(client=client, **given)
            assert answer.status_code == NO_MEASURING.get(name, 200), name
            assert answer.parsed is not None, name


def test_openapi_fetch_has_every_operation(server):
    node = Path(sys.executable).with_name("node")
    script = Path(__file__).with_name("every-operation.js")
    done = subprocess.run(
        [node, script, server], capture_output=True, text=True, cwd=ROOT, check=False
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == dict.fromkeys(CALLED, 200) | NO_MEASURING
