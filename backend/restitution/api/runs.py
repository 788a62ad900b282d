"""Measurements that run in the background, one at a time."""

import logging
import secrets
import threading
from dataclasses import dataclass, field

from restitution.studies.accuracy.scenes import SceneName
from restitution.studies.accuracy.tradeoff import Measurement, study_tradeoff


@dataclass
class Run:
    """A measurement of a scene, under way or over.

    Attributes
    ----------
    id, scene : str
        Its name and what it measures.
    state : str
        ``running``, ``done``, ``cancelled`` or ``failed``.
    progress : float
        0 … 1.
    result : Measurement, or None
        Once it is done.
    """

    id: str
    scene: SceneName
    state: str = "running"
    progress: float = 0.0
    result: Measurement | None = None
    _cancelled: threading.Event = field(default_factory=threading.Event)

    def cancel(self) -> None:
        """Let it stop after the row that it is at; once it is over there is nothing to stop."""
        self._cancelled.set()

    def measure(self) -> None:
        """Measure row by row until it is done or cancelled."""
        try:
            for progress, measurement in study_tradeoff(self.scene):
                self.progress = progress
                if progress == 1.0:
                    self.result, self.state = measurement, "done"
                elif self._cancelled.is_set():
                    self.state = "cancelled"
                    return
        except Exception:
            logging.getLogger(__name__).exception("measuring %s", self.scene)
            self.state = "failed"


class Runs:
    """The last run; the next one can start when it is over."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self.last: Run | None = None

    def start(self, scene: SceneName) -> Run | None:
        """Return a new run, None while another one is under way."""
        with self._lock:
            if self.last and self.last.state == "running":
                return None
            self.last = Run(secrets.token_hex(8), scene)
            threading.Thread(target=self.last.measure, name="tradeoff", daemon=True).start()
            return self.last
