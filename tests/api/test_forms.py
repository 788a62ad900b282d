"""The forms of an answer: csv, npz and base64 say what JSON says, in every call."""

import base64
import csv
import io

import numpy as np
import pytest

COLLISION = {"kappa": 18, "mu_over_alpha": 1.4, "gt_over_gn": 0.4}
GRID = {"mu_over_alpha": 1, "kappa_count": 4, "gt_over_gn_count": 3, "gt_over_gn_max": 3}
ALL = "epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote,error"
CALLS = {
    "collision": ("/collision", COLLISION),
    "collision, μ = 0": ("/collision", {**COLLISION, "mu_over_alpha": 0}),
    "collision, stiff": ("/collision", {**COLLISION, "method": "stiff"}),
    "trace": ("/trace", {**COLLISION, "samples": 7}),
    "trace, coulomb": ("/trace", {**COLLISION, "samples": 7, "method": "coulomb"}),
    "cut": ("/cut", {"along": "kappa", "mu_over_alpha": 1, "gt_over_gn": 1, "count": 5}),
    "map": ("/map", {**GRID, "quantities": ALL}),
    "map, coulomb": ("/map", {**GRID, "method": "coulomb"}),
    "post": ("/collisions", {"kappa": [5, 18], "mu_over_alpha": 1, "gt_over_gn": [0.1, 3]}),
}
PARTS = {"energy", "estimates", "sensitivity"}
every_call = pytest.mark.parametrize(("path", "parameters"), CALLS.values(), ids=CALLS)


def send(service, path, parameters, **form):
    if path == "/collisions":
        response = service.post(parameters, **form)
    else:
        response = service.get(path, **parameters, **form)
    assert response.status_code == 200, response.text
    return response


def rows_of(response):
    assert response.headers["content-type"].startswith("text/csv")
    return list(csv.reader(io.StringIO(response.text, newline="")))


def same(text, value):
    if isinstance(value, bool) or value is None or isinstance(value, str):
        return text == {True: "true", False: "false", None: ""}.get(value, value)
    return float(text) == value


def flat(value, prefix=""):
    if not isinstance(value, dict):
        return {prefix[:-1]: value}
    return {
        k: v for name, inner in value.items() for k, v in flat(inner, f"{prefix}{name}.").items()
    }


def unpacked(value):
    """Return a JSON answer with its typed arrays as lists, NaN as None."""
    if isinstance(value, dict) and "bdata" in value:
        assert value.keys() == {"dtype", "shape", "bdata"}
        shape = tuple(int(n) for n in value["shape"].split(","))
        array = np.frombuffer(base64.b64decode(value["bdata"], validate=True), "<" + value["dtype"])
        listed = array.reshape(shape).astype(object)
        return np.where(array.reshape(shape) != array.reshape(shape), None, listed).tolist()
    if isinstance(value, dict):
        return {name: unpacked(inner) for name, inner in value.items()}
    return value


@every_call
def test_base64_holds_the_same_numbers(service, path, parameters):
    plain = send(service, path, parameters).json()
    packed = send(service, path, parameters, encoding="base64").json()
    assert unpacked(packed) == plain


@every_call
def test_base64_leaves_no_list_of_numbers(service, path, parameters):
    packed = flat(send(service, path, parameters, encoding="base64").json())
    lists = {name: value for name, value in packed.items() if isinstance(value, list)}
    lists.pop("episodes", None)
    assert all(isinstance(item, str | bool) for value in lists.values() for item in value), lists


@pytest.mark.parametrize(
    ("call", "name", "dtype", "shape"),
    [
        ("trace", "time", "f8", "11"),
        ("trace", "regime", "i1", "11"),
        ("trace", "switch_times", "f8", "4"),
        ("cut", "values", "f8", "5"),
        ("cut", "switches", "i4", "5"),
        ("map", "kappa", "f8", "4"),
        ("map", "epsilon_t", "f8", "3,4"),
        ("map", "switches", "i4", "3,4"),
        ("map", "stiff_bound", "f8", "3,4"),
        ("post", "epsilon_t", "f8", "2"),
        ("post", "epsilon_n", "f8", "2"),
        ("post", "switches", "i4", "2"),
        ("post", "error_bound", "f8", "2"),
    ],
)
def test_base64_has_the_contracts_types(service, call, name, dtype, shape):
    packed = send(service, *CALLS[call], encoding="base64").json()[name]
    assert packed["dtype"] == dtype
    assert packed["shape"] == shape


def test_base64_has_nan_where_json_has_null(service):
    packed = send(service, *CALLS["map"], encoding="base64").json()["stiff_bound"]
    bound = np.frombuffer(base64.b64decode(packed["bdata"]), "<f8").reshape(3, 4)
    assert np.array_equal(np.isnan(bound), [[False] * 4, [False] * 4, [True] * 4])


@every_call
def test_npz_has_one_array_per_key(service, path, parameters):
    plain = flat(send(service, path, parameters).json())
    response = send(service, path, parameters, format="npz")
    with np.load(io.BytesIO(response.content), allow_pickle=False) as arrays:
        for name in plain.keys() - {"episodes"} - PARTS:
            found = arrays[name]
            assert found.dtype.kind in "fibU", name
            listed = found.tolist()
            if found.dtype.kind == "f":
                listed = np.where(np.isnan(found), None, found.astype(object)).tolist()
            assert listed == plain[name], name


def test_npz_has_the_contracts_types(service):
    response = send(service, *CALLS["trace"], format="npz")
    with np.load(io.BytesIO(response.content)) as arrays:
        assert arrays["regime"].dtype == np.int8
        assert arrays["time"].dtype == np.float64
    response = send(service, *CALLS["map"], format="npz")
    with np.load(io.BytesIO(response.content)) as arrays:
        assert arrays["switches"].dtype == np.int32


@pytest.mark.parametrize("call", ["collision", "collision, μ = 0", "collision, stiff"])
def test_csv_of_a_collision_is_one_row_without_episodes(service, call):
    header, *rows = rows_of(send(service, *CALLS[call], format="csv"))
    plain = flat(send(service, *CALLS[call]).json())
    assert len(rows) == 1
    found = dict(zip(header, rows[0], strict=True))
    assert not {name for name in found if name.startswith("episodes.")}
    assert {"parameters.kappa", "energy.initial", "estimates.coulomb"} <= found.keys()
    for name in plain.keys() - {"episodes"} - PARTS:
        assert same(found[name], plain[name]), (name, found[name], plain[name])


@pytest.mark.parametrize("call", ["collision, μ = 0", "collision, stiff"])
def test_csv_and_npz_have_the_same_names_whatever_is_null(service, call):
    def names(call):
        header = rows_of(send(service, *CALLS[call], format="csv"))[0]
        with np.load(io.BytesIO(send(service, *CALLS[call], format="npz").content)) as arrays:
            return header, arrays.files

    assert names(call) == names("collision")


def test_csv_of_a_trace_is_one_row_per_sample(service):
    header, *rows = rows_of(send(service, *CALLS["trace"], format="csv"))
    plain = send(service, *CALLS["trace"]).json()
    assert len(rows) == len(plain["time"]) == 11
    assert set(header) >= {"time", "tangential_force_over_mu", "regime"}
    for name, column in zip(header, zip(*rows, strict=True), strict=True):
        assert [float(text) for text in column] == plain[name], name


def test_csv_of_a_cut_is_one_row_per_value(service):
    header, *rows = rows_of(send(service, *CALLS["cut"], format="csv"))
    plain = send(service, *CALLS["cut"]).json()
    assert header == ["kappa", "epsilon_t", "switches"]
    columns = [[float(text) for text in column] for column in zip(*rows, strict=True)]
    assert columns == [plain["values"], plain["epsilon_t"], plain["switches"]]


def test_csv_of_a_map_is_long_with_kappa_fastest(service):
    header, *rows = rows_of(send(service, *CALLS["map"], format="csv"))
    plain = send(service, *CALLS["map"]).json()
    assert header == ["kappa", "gt_over_gn", *ALL.split(",")]
    expected = [
        [kappa, gt_over_gn, *(plain[name][j][i] for name in ALL.split(","))]
        for j, gt_over_gn in enumerate(plain["gt_over_gn"])
        for i, kappa in enumerate(plain["kappa"])
    ]
    assert [[None if text == "" else float(text) for text in row] for row in rows] == expected
    assert any(None in row for row in expected)


def test_csv_of_many_collisions_is_one_row_each(service):
    header, *rows = rows_of(send(service, *CALLS["post"], format="csv"))
    plain = send(service, *CALLS["post"]).json()
    assert header == list(plain)
    for i, row in enumerate(rows):
        assert all(same(text, plain[name][i]) for name, text in zip(header, row, strict=True)), row


def test_csv_of_no_collisions_is_a_header(service):
    empty = {"kappa": [], "mu_over_alpha": 1, "gt_over_gn": []}
    (header,) = rows_of(send(service, "/collisions", empty, format="csv"))
    assert header[:3] == ["epsilon_t", "epsilon_n", "switches"]


@every_call
def test_answers_are_the_same_to_the_byte_when_asked_again(service, path, parameters):
    for form in ({}, {"format": "csv"}, {"format": "npz"}, {"encoding": "base64"}):
        first, second = (send(service, path, parameters, **form).content for _ in range(2))
        assert first == second, form


@pytest.mark.parametrize("form", [{"format": "xml"}, {"encoding": "gzip"}, {"format": ""}], ids=str)
@every_call
def test_other_forms_are_refused(service, path, parameters, form):
    ((name, value),) = form.items()
    if path == "/collisions":
        wrong = service.wrong_body(parameters, **form)
    else:
        wrong = service.wrong(path, **parameters, **form)
    assert wrong.keys() == {name}
    assert wrong[name]["value"] == value


def test_switches_stay_integers_when_some_are_null(service):
    body = {"kappa": [63, 1e30], "mu_over_alpha": 1, "gt_over_gn": 0.97}
    switches = service.collisions(body)["switches"]
    assert switches == [8, None]
    assert type(switches[0]) is int
    rows = service.post(body, format="csv").text.splitlines()
    assert [row.split(",")[2] for row in rows] == ["switches", "8", ""]
