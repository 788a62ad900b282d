"""What the service counts for Prometheus, beside the requests and their durations."""

from prometheus_client import Counter, Gauge, Histogram

COMPUTE = Histogram(
    "restitution_compute_seconds",
    "Time of computing an answer, without reading the request and writing the answer",
    ["call"],
    buckets=(0.0001, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0),
)

METHOD = Counter(
    "restitution_method_chosen", "Answers by the method that gave them, or mixed", ["method"]
)

REFUSED = Counter(
    "restitution_requests_refused", "Requests refused for their cost or for saturation", ["reason"]
)

WAITING = Gauge(
    "restitution_computations",
    "Computations in threads, under way or waiting",
    multiprocess_mode="livesum",
)
