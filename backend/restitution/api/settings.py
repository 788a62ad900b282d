"""What an administrator may set: environment variables that begin with RESTITUTION_."""

import os
from pathlib import Path

from pydantic import Field
from pydantic_settings import BaseSettings, SettingsConfigDict


class Settings(BaseSettings):
    """Settings of the service; docs/deployment.md says when to change them."""

    model_config = SettingsConfigDict(env_prefix="RESTITUTION_")

    frontend_directory: Path = Path(__file__).parents[3] / "frontend"
    """Folder of the page; that of the checkout unless the package is installed elsewhere."""

    tradeoff_runs: bool = False
    """Whether anyone may have the methods measured anew: half a minute of a core at a time."""

    workers: int = Field(1, ge=1)
    """Processes that serve, each with its own lines of waiting requests."""

    most_quick: int = Field(40, ge=1)
    """Requests of under some milliseconds that wait in one process; more are answered 503."""

    most_long: int = Field(os.cpu_count() or 1, ge=1)
    """Longer computations at the same time in one process; by default one for each core."""

    most_waiting: int = Field(32, ge=0)
    """Longer computations that wait in one process; more are answered 503."""

    log_requests: bool = False
    """Whether every request is logged; else those that are refused for saturation or fail."""
