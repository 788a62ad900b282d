"""What an administrator may set: environment variables that begin with RESTITUTION_."""

from pathlib import Path

from pydantic_settings import BaseSettings, SettingsConfigDict


class Settings(BaseSettings):
    """Settings of the service."""

    model_config = SettingsConfigDict(env_prefix="RESTITUTION_")

    frontend_directory: Path = Path(__file__).parents[3] / "frontend"
    """Folder of the page; that of the checkout unless the package is installed elsewhere."""

    tradeoff_runs: bool = False
    """Whether anyone may have the methods measured anew: half a minute of a core at a time."""
