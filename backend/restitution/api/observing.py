"""What an operator sees: request ids, a structured log, metrics; nothing about who asked."""

import logging
import sys

import structlog
from asgi_correlation_id import CorrelationIdMiddleware, correlation_id
from fastapi import FastAPI, Response
from prometheus_client import CONTENT_TYPE_LATEST
from prometheus_fastapi_instrumentator import Instrumentator, metrics
from structlog.typing import EventDict, Processor, WrappedLogger

LOGGER = structlog.get_logger("restitution")


def _request_id(_: WrappedLogger, __: str, event: EventDict) -> EventDict:
    """Add the id of the request that is being answered."""
    if request_id := correlation_id.get():
        event["request_id"] = request_id
    return event


def set_up_log() -> None:
    """Log to standard error: lines for a terminal, else JSON; those of libraries too."""
    shared: list[Processor] = [
        structlog.stdlib.add_log_level,
        structlog.processors.TimeStamper(fmt="iso", utc=True),
        _request_id,
    ]
    on_terminal = sys.stderr.isatty()
    renderer: list[Processor] = (
        [structlog.dev.ConsoleRenderer()]
        if on_terminal
        else [structlog.processors.format_exc_info, structlog.processors.JSONRenderer()]
    )
    structlog.configure(
        processors=[*shared, structlog.stdlib.ProcessorFormatter.wrap_for_formatter],
        wrapper_class=structlog.make_filtering_bound_logger(logging.INFO),
        logger_factory=structlog.stdlib.LoggerFactory(),
        cache_logger_on_first_use=True,
    )
    handler = logging.StreamHandler(sys.stderr)
    handler.setFormatter(
        structlog.stdlib.ProcessorFormatter(
            foreign_pre_chain=shared,
            processors=[structlog.stdlib.ProcessorFormatter.remove_processors_meta, *renderer],
        )
    )
    logging.basicConfig(handlers=[handler], level=logging.WARNING, force=True)
    logging.getLogger("restitution").setLevel(logging.INFO)


def observe(app: FastAPI, *, log_requests: bool) -> None:
    """Count and log the requests of `app`; let it tell the numbers at ``/metrics``."""

    def log(info: metrics.Info) -> None:
        if log_requests or info.modified_status >= "500":
            LOGGER.info(
                "request",
                method=info.method,
                # the route, not the address: what was asked for is nobody's business
                route=info.modified_handler,
                status=int(info.modified_status),
                milliseconds=round(1e3 * info.modified_duration, 1),
            )

    instrumentator = Instrumentator(should_group_status_codes=False)
    instrumentator.add(metrics.default(latency_lowr_buckets=(0.003, 0.01, 0.03, 0.1, 0.3, 1.0)))
    instrumentator.add(log)
    instrumentator.instrument(app)
    instrumentator.expose(
        app,
        tags=["service"],
        name="metrics",
        summary="For Prometheus",
        response_class=Response,
        responses={200: {"content": {CONTENT_TYPE_LATEST: {"schema": {"type": "string"}}}}},
    )
    # an id of another form than ours is replaced: not worth a warning for each request
    logging.getLogger("asgi_correlation_id").setLevel(logging.ERROR)
    app.add_middleware(CorrelationIdMiddleware)
