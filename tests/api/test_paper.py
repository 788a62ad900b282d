"""``GET /paper``: the contract's keys, the forms, and what it costs."""

import csv
import io

import numpy as np
import pytest

from restitution.paper import study_paper
from work import counted

FIELDS = {"id", "kind", "section", "printed", "computed", "verdict", "evidence", "link"}


@pytest.fixture(scope="module")
def items(service):
    return service.answer("/paper")["items"]


def test_items_have_the_contracts_fields(items):
    assert items == [vars(item) for item in study_paper()]
    for item in items:
        assert item.keys() == FIELDS
        assert all(isinstance(value, str) and value for value in item.values())
        assert item["kind"] in {"equation", "figure", "number", "claim"}
        assert item["verdict"] in {"holds", "corrected", "fails"}
        assert item["link"].startswith("?")


def test_corrections_and_definitions_name_their_statements(service, items):
    answer = service.answer("/paper")
    assert answer.keys() == {"items", "corrections", "definitions"}
    verdicts = {item["id"]: item["verdict"] for item in items}
    mended = [name for point in answer["corrections"] for name in point["statements"]]
    assert len(mended) == list(verdicts.values()).count("corrected")
    assert {verdicts[name] for name in mended} == {"corrected"}
    assert {verdicts[name] for name in answer["definitions"]} == {"holds"}


def test_paper_has_every_form(service, items):
    rows = list(csv.DictReader(io.StringIO(service.get("/paper", format="csv").text)))
    assert rows == items
    with np.load(io.BytesIO(service.get("/paper", format="npz").content)) as arrays:
        assert arrays["verdict"].tolist() == [item["verdict"] for item in items]


def test_paper_is_computed_once_and_cached(service, items):
    assert items
    with counted() as work:
        response = service.get("/paper")
    # a second time it is only written, on the event loop
    assert work == {"quick": 1}
    again = service.get("/paper", {"If-None-Match": response.headers["etag"]})
    assert again.status_code == 304


def test_paper_takes_no_other_parameter(service):
    assert "kappa" in service.wrong("/paper", kappa=1)
