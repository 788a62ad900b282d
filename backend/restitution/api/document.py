"""The description of the service in OpenAPI: what routes say of their answers, and the document.

A route names the model of its answer; headers, forms and refusals follow from the kind of call.
Nothing of this acts on a request.
"""

import re
from collections.abc import Mapping
from typing import Any, Literal, get_args

from fastapi import FastAPI
from fastapi.routing import APIRoute
from pydantic import TypeAdapter
from pydantic.json_schema import GenerateJsonSchema
from typing_extensions import is_typeddict

from restitution import __version__
from restitution.bounds import Meaning, annotations, requirement, said
from restitution.wire import answers
from restitution.wire.reading import adapter

Described = dict[int | str, dict[str, Any]]
"""Status → response, as the decorators of FastAPI take it."""

ABOUT = """\
Two viscoelastic spheres with friction collide: what comes out, how it goes, and what every method
makes of it. After T. Schwager, V. Becker, T. Pöschel, *Coefficient of tangential restitution for
viscoelastic spheres*, [Eur. Phys. J. E 27, 107 (2008)](https://doi.org/10.1140/epje/i2007-10356-3).

Times, lengths, velocities and forces are scaled by t_scale, ξ_scale, g_n and m_eff ξ_scale/t_scale²
(Eqs. 17–24), except in calls about real spheres, which are in SI units.
ε_t = g_t(t_c)/g_t(0) at the point of contact: +1 for smooth spheres, −1 for gear wheels.

Every answer but that of `/tradeoff` is a function of the request alone. A number that does not
exist is null in JSON, NaN in `npz` and base64, empty in `csv`. Refusals are
`application/problem+json` (RFC 9457) and name everything that is wrong at once; methods that an
address does not have are answered 405 with `Allow`, addresses that do not exist 404.

What is under `/api/v1` keeps its meaning: names, units, signs and defaults stay. Parameters, keys
of answers, words that a key may hold and calls may be added: clients pass over what they do not
know. Numbers may change with a version within their `error_bound`, and the ETags with them. What
is to go is marked `deprecated` here and in the changelog, and works for another year, in which its
answers carry `Deprecation` (RFC 9745) and `Sunset` (RFC 8594). A change of meaning would come under
`/api/v2`, with a year of both. Faults are mended in the latest version alone."""

TAGS = [
    {"name": "collisions", "description": "One collision, many, along a cut, over a map."},
    {"name": "real spheres", "description": "Collisions in SI units."},
    {"name": "table", "description": "ε_t(κ, ψ) for other codes."},
    {"name": "tradeoff", "description": "Speed and accuracy of the methods."},
    {"name": "paper", "description": "What the paper prints, and what is computed now."},
    {"name": "presets", "description": "Collisions worth a look."},
    {"name": "service", "description": "What a supervisor asks."},
]


def _header(description: str, pattern: str, *, required: bool = True) -> dict[str, Any]:
    schema = {"type": "string", "pattern": pattern}
    return {"description": description, "required": required, "schema": schema}


HEADERS = {
    "ETag": _header("Strong; of the request as understood and the version.", '^"[!#-~]+"$'),
    "CacheForADay": _header("For a day.", "^public, max-age=86400$"),
    "NoStore": _header("Not to be kept.", "^no-store$"),
    "ServerTiming": _header("What computing took, in ms.", r"^compute;dur=\d+(\.\d+)?$"),
    "RetryAfter": _header("Seconds after which to ask again.", r"^\d+$"),
    "Location": _header("Where its progress is told.", "^runs/[0-9a-f]+$"),
}


def _with_headers(**names: str) -> dict[str, Any]:
    return {
        name.replace("_", "-"): {"$ref": f"#/components/headers/{header}"}
        for name, header in names.items()
    }


CACHED = _with_headers(ETag="ETag", Cache_Control="CacheForADay")
TIMED = _with_headers(Server_Timing="ServerTiming")
NOT_KEPT = _with_headers(Cache_Control="NoStore")

PROBLEMS = {
    400: ("MalformedBody", "The body is not a JSON object."),
    403: ("SwitchedOff", "Measuring anew is switched off here."),
    404: ("UnknownRun", "There is no such measurement, or another one has followed it."),
    408: ("TooSlow", "The body did not come in time."),
    409: ("UnderWay", "A measurement is under way."),
    413: ("TooCostly", "The request or its body is beyond a limit; `detail` has cost and limit."),
    415: ("NotJson", "The body is not `application/json`."),
    422: ("WrongParameters", "Parameters are wrong; `errors` has all of them."),
    503: ("Busy", "The service is saturated, or its kernels are being compiled."),
}
"""Status → name of its response, and when it is given."""


def refusals(*statuses: int) -> Described:
    """Return the responses of refusals with `statuses`."""
    return {
        status: {"$ref": f"#/components/responses/{PROBLEMS[status][0]}"} for status in statuses
    }


JSON = "application/json"
TEXT: dict[str, Any] = {"schema": {"type": "string"}}
FORMS: dict[str, dict[str, Any]] = {
    "csv": {"text/csv; charset=utf-8": TEXT},
    "npz": {"application/x-npz": {}},
    "c": {"text/plain; charset=utf-8": TEXT},
    "python": {"text/plain; charset=utf-8": TEXT},
}
"""Form of an answer beside JSON → its content."""


def _contents(forms: tuple[str, ...]) -> dict[str, Any]:
    return {kind: of for form in forms for kind, of in FORMS.get(form, {}).items()}


def computed(query: type, answer: Any) -> Described:
    """Return the responses of a GET that computes `answer`, or texts for other codes if None."""
    return stored(query, answer) | refusals(413, 503)


def stored(query: type, answer: Any) -> Described:
    """Return the responses of a GET, in all the forms that its query may ask for."""
    forms = get_args(annotations(query).get("format", Literal["json"]))
    found = {
        200: _success(answer, _contents(forms), CACHED | TIMED),
        304: {"$ref": "#/components/responses/Unchanged"},
    }
    return found | refusals(422)


def posted(answer: Any) -> Described:
    """Return the responses of a POST whose body is JSON, in all their forms."""
    success = _success(answer, _contents(("csv", "npz")), NOT_KEPT | TIMED)
    return {200: success} | refusals(400, 408, 413, 415, 422, 503)


def told(model: Any, status: int = 200) -> Described:
    """Return the response of a call about a measurement, or its start if `status` is 202."""
    headers = NOT_KEPT | (_with_headers(Location="Location") if status == 202 else {})
    return {status: _success(model, {}, headers)}


def _success(model: Any, forms: dict[str, Any], headers: dict[str, Any]) -> dict[str, Any]:
    answer: dict[str, Any] = {"description": "The answer.", "headers": headers}
    if model is None:
        return answer | {"content": dict(forms)}
    # generators of clients take the first
    return answer | {"model": model, "content": {JSON: {}, **forms}}


def about() -> dict[str, Any]:
    """Return what the application says of itself, as arguments of `FastAPI`."""
    return {
        "title": "Restitution",
        "version": __version__,
        "summary": "Coefficient of tangential restitution of colliding frictional spheres",
        "description": ABOUT,
        "license_info": {"name": "MIT", "identifier": "MIT"},
        # relative to the document, which may stand below any path of a proxy
        "servers": [{"url": "./", "description": "this server"}],
        "openapi_tags": TAGS,
        "generate_unique_id_function": operation_id,
    }


def operation_id(route: APIRoute) -> str:
    """Return what an operation is called in the document."""
    return route.name


REFERENCE = "#/components/schemas/{model}"
SCHEMAS = "x-schemas"


def asked(query: type, example: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Return what an operation says of its parameters; those that it needs stand first."""
    schema = adapter(query).json_schema(ref_template=REFERENCE)
    needed = schema.get("required", [])
    found = [
        _parameter(name, annotation, schema["properties"][name], is_needed=name in needed)
        | ({"example": example[name]} if example and name in example else {})
        for name, annotation in annotations(query).items()
    ]
    return {
        "parameters": sorted(found, key=lambda parameter: not parameter["required"]),
        # taken from there when the document is complete
        SCHEMAS: schema.get("$defs", {}),
    }


def _parameter(
    name: str, annotation: Any, schema: dict[str, Any], *, is_needed: bool
) -> dict[str, Any]:
    """Return a parameter of a query as a reader needs it."""
    schema.pop("title", None)
    # an optional parameter is left out, there is no null in a query
    kinds = [kind for kind in schema.get("anyOf", []) if kind != {"type": "null"}]
    if len(kinds) == 1:
        schema |= kinds[0]
        del schema["anyOf"]
    if schema.get("default", ...) is None:
        del schema["default"]
    meaning = said(annotation, Meaning)
    words = requirement(annotation)
    description = f"{meaning.text}: {words}" if meaning else words
    schema.pop("description", None)
    if schema.get("type") == "number" and "e-" in repr(schema.get("default")):
        # Swagger UI takes 1e-10 for no number and would refuse to send its own default
        description += f"; {schema.pop('default'):g} if left out"
    return {
        "name": name,
        "in": "query",
        "required": is_needed,
        "schema": schema,
        "description": description,
    }


def sent(body: type, example: Mapping[str, Any], form: type) -> dict[str, Any]:
    """Return what an operation says of its body, and of its parameters: those of a form."""
    schema = {"$ref": f"#/components/schemas/{body.__name__}"}
    content = {JSON: {"schema": schema, "example": dict(example)}}
    return asked(form) | {"requestBody": {"required": True, "content": content}}


def install(app: FastAPI, bodies: list[type]) -> None:
    """Let the document of `app` have what decorators do not say, and the schemas of `bodies`."""
    described = app.openapi

    def openapi() -> dict[str, Any]:
        if app.openapi_schema is None:
            _complete(described(), bodies)
        assert app.openapi_schema is not None
        return app.openapi_schema

    app.openapi = openapi  # type: ignore[method-assign] # as FastAPI's manual has it


def _complete(document: dict[str, Any], bodies: list[type]) -> None:
    schemas = document["components"]["schemas"]
    for operations in document["paths"].values():
        for operation in operations.values():
            schemas |= operation.pop(SCHEMAS, {})
            if "304" in operation["responses"]:
                known = {"$ref": "#/components/parameters/IfNoneMatch"}
                operation.setdefault("parameters", []).append(known)
            for response in operation["responses"].values():
                if "$ref" in response:
                    # FastAPI's own words beside it
                    response.pop("description", None)
    components = document["components"]
    # those that FastAPI names, anew: it says of a member with a default that it may be missing
    named = components["schemas"].keys() | {"Problem"}
    whole = [each for each in vars(answers).values() if getattr(each, "__name__", "") in named]
    components["schemas"] |= _schemas("serialization", *filter(is_typeddict, whole))
    components["schemas"] |= _schemas("validation", *bodies)
    for schema in components["schemas"].values():
        if text := schema.get("description"):
            schema["description"] = ABOUT_PYTHON.split(text, maxsplit=1)[0]
    components["parameters"] = {"IfNoneMatch": IF_NONE_MATCH}
    components["headers"] = HEADERS
    components["responses"] = _responses()


ABOUT_PYTHON = re.compile(r"\n\n(?:Raises|Examples)\n-+\n")
"""Where the docstring of a class begins to speak of Python alone."""

IF_NONE_MATCH = {
    "name": "If-None-Match",
    "in": "header",
    "description": "ETags of answers at hand, with commas between them, or `*`",
    "schema": {"type": "string"},
}


class _ForClients(GenerateJsonSchema):
    """Schemas as generators of clients need them."""

    def literal_schema(self, schema: Any) -> Any:
        """Return the schema of words; a single one is a choice, too, for it may have another kind.

        openapi-python-client takes ``const`` for all that there is and reads no number beside it.
        """
        found = super().literal_schema(schema)
        if isinstance(found.get("const"), str):
            found["enum"] = [found.pop("const")]
        return found

    def field_is_required(self, field: Any, total: bool) -> bool:
        """Return whether a member is always there: of an answer, whatever its default."""
        is_made = self.mode == "serialization" and field["type"] == "dataclass-field"
        return is_made or super().field_is_required(field, total)


def _schemas(mode: Literal["serialization", "validation"], *models: Any) -> dict[str, Any]:
    """Return the schemas of answers or bodies, with all that they refer to."""
    _, found = TypeAdapter.json_schemas(
        [(model, mode, TypeAdapter(model)) for model in models],
        ref_template=REFERENCE,
        schema_generator=_ForClients,
    )
    schemas: dict[str, Any] = found["$defs"]
    return schemas


def _responses() -> dict[str, Any]:
    """Return the responses that calls share."""
    content = {"application/problem+json": {"schema": {"$ref": "#/components/schemas/Problem"}}}
    found: dict[str, Any] = {
        name: {"description": when, "headers": NOT_KEPT, "content": content}
        for name, when in PROBLEMS.values()
    }
    retry = _with_headers(Retry_After="RetryAfter")
    found["Busy"] = found["Busy"] | {"headers": NOT_KEPT | retry}
    found["Unchanged"] = {"description": "The client has it already.", "headers": CACHED}
    return found
