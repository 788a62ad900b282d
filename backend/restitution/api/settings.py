"""What an administrator may set: environment variables that begin with RESTITUTION_."""

import difflib
import ipaddress
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

from annotated_types import Ge, Le
from pydantic import AfterValidator, StringConstraints

from restitution.bounds import Words, annotations, closed
from restitution.errors import RestitutionError
from restitution.wire.reading import read_query
from restitution.wire.refusals import RefusedParametersError

PREFIX = "RESTITUTION_"

PAGES = Path(__file__).parents[1] / "frontend", Path(__file__).parents[3] / "frontend"

MISSPELT = 0.8
"""How much of a name must be a setting's to be meant for it, as difflib counts."""


PATH = r"(/[\w.~-]+)+"
"""Of a proxy, below which it shows the service; no slash at its end."""


def _networks(text: str) -> str:
    """Return addresses and networks with commas between them, or *; ValueError for others."""
    for each in text.split(",") if text.strip() != "*" else []:
        ipaddress.ip_network(each.strip())
    return text


class SettingsError(RestitutionError):
    """A line for each setting that cannot be what it is."""


@closed
class Settings:
    """Settings of the service; docs/deployment.md says when to change them."""

    frontend_directory: Path = next(filter(Path.is_dir, PAGES), PAGES[-1])
    """Folder of the page: of an installed package in it, else that of the checkout."""

    tradeoff_runs: Annotated[bool, Words("true or false")] = False
    """Whether anyone may have the methods measured anew: half a minute of a core at a time."""

    workers: Annotated[int, Ge(1), Le(256)] = 1
    """Processes that serve, each with its own lines of waiting requests."""

    most_quick: Annotated[int, Ge(1)] = 40
    """Requests of under some milliseconds that wait in one process; more are answered 503."""

    most_long: Annotated[int, Ge(1)] = os.cpu_count() or 1
    """Longer computations at the same time in one process; by default one for each core."""

    most_waiting: Annotated[int, Ge(0)] = 32
    """Longer computations that wait in one process; more are answered 503."""

    root_path: Annotated[
        str, StringConstraints(pattern=f"^({PATH})?$"), Words("a path as /restitution")
    ] = ""
    """Path at which a proxy shows the service, which it cuts off before it passes requests on."""

    forwarded_allow_ips: Annotated[
        str,
        AfterValidator(_networks),
        Words("addresses and networks with commas between them, or *"),
    ] = "127.0.0.1,::1"
    """Of proxies whose X-Forwarded-Prefix is believed, which says the same."""

    log_requests: Annotated[bool, Words("true or false")] = False
    """Whether every request is logged; else those that are refused for saturation or fail."""


def settings_of_environment() -> Settings:
    """Return what the environment sets; `SettingsError` says all that is wrong with it."""
    names = annotations(Settings)
    given = {name: value for name, value in _given() if name in names}
    faults = [
        f"{PREFIX}{name.upper()} is no setting: perhaps {PREFIX}{meant.upper()} is meant"
        for name, _ in _given()
        if name not in names and (meant := _meant(name))
    ]
    settings = Settings()
    try:
        settings = read_query(Settings, list(given.items()))
    except RefusedParametersError as refused:
        faults += [
            _fault(entry["parameter"], given[entry["parameter"]], entry["requirement"])
            for entry in refused.errors
        ]
    folder = given.get("frontend_directory", str(settings.frontend_directory))
    if not Path(folder, "index.html").is_file():
        requirement = "a folder that holds index.html, as frontend of a checkout does"
        faults.append(_fault("frontend_directory", folder, requirement))
    if faults:
        raise SettingsError("\n".join(faults))
    return settings


def strangers() -> list[str]:
    """Return variables that look like settings and are none, nor misspelt ones.

    They may be meant for somebody else, as docker compose, or come from Kubernetes, which tells
    a service named restitution where it is.
    """
    return [
        f"{PREFIX}{name.upper()}"
        for name, _ in _given()
        if name not in annotations(Settings) and not _meant(name)
    ]


def _given() -> Iterator[tuple[str, str]]:
    for name, value in sorted(os.environ.items()):
        if name.upper().startswith(PREFIX):
            yield name[len(PREFIX) :].lower(), value


def _meant(name: str) -> str | None:
    """Return the setting that a misspelt name is meant for."""
    return next(iter(difflib.get_close_matches(name, annotations(Settings), 1, MISSPELT)), None)


def _fault(name: str, value: str, requirement: str) -> str:
    return f"{PREFIX}{name.upper()} must be {requirement}, got {value!r}"
