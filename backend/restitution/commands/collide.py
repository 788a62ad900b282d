"""``restitution collide``: a collision of real bodies on the command line."""

import json
import math
from collections.abc import Callable
from typing import Any, BinaryIO, TypeVar

import click

from restitution.commands.terminal import Command, say_json
from restitution.studies.spheres.collision import ScalingStudy, study_scaling
from restitution.wire.bodies import ScalingBody
from restitution.wire.formats import in_one_piece
from restitution.wire.impact_options import OPTIONS, by_option, told_body
from restitution.wire.parsing import in_utf8, parse_nested
from restitution.wire.reading import read_object
from restitution.wire.refusals import RefusedParametersError
from restitution.wire.results import scaling_result

Function = TypeVar("Function", bound=Callable[..., Any])


def _with_options(command: Function) -> Function:
    """Add the options that a body of the service has."""
    for option in reversed(OPTIONS):
        member = ".".join(option.path)
        add = click.option(
            option.name,
            nargs=option.size,
            metavar="VALUE" if option.size == 1 else "X Y Z",
            help=f"{member}: {option.words}.",
        )
        command = add(command)
    return command


class _Collide(Command):
    """Has options for the members of a body."""

    def names(self) -> dict[str, str]:
        """Return what options are called elsewhere, each with its name here."""
        return super().names() | {option.path[-1]: option.name for option in reversed(OPTIONS)}


@click.command(cls=_Collide)
@click.argument("file", type=click.File("rb"), required=False)
@_with_options
@click.option("--wall", is_flag=True, help="The second body is a wall, not a sphere.")
@click.option("--json", "in_full", is_flag=True, help="Print JSON, as the service does.")
def collide(file: BinaryIO | None, in_full: bool, wall: bool, **given: Any) -> None:
    """Let two spheres, or a sphere and a wall, collide.

    FILE (- for standard input) holds the JSON of POST /api/v1/scaling. Options tell its members,
    in place of those of FILE or without one. Then the second body is as the first in all that is
    not said of it, the stiffness is Mindlin's and the tangential velocity 0.
    """
    told = wall or any(value is not None for value in given.values())
    if not file and not told:
        raise click.UsageError("give FILE, or options: --radius, --density, --friction, …")
    text = file.read() if file else None
    if told:
        begun = None if text is None else parse_nested(in_utf8(text))
        text = json.dumps(told_body(begun, given, wall=wall)).encode()
    assert text is not None
    try:
        asked = read_object(ScalingBody, text)
    except RefusedParametersError as refused:
        raise RefusedParametersError(
            by_option(refused.errors, given, alone=file is None)
        ) from refused
    study = study_scaling(asked, asked.impact)
    if in_full:
        say_json(in_one_piece(scaling_result(study), "json"))
    else:
        click.echo(_summary(study))


def _summary(study: ScalingStudy) -> str:
    """Return a collision of real bodies in lines."""
    psi = math.inf if study.psi is None else study.psi
    beta_0 = study.walton_beta_0
    lines = [
        f"epsilon_t  {study.epsilon_t:.10g}  (error at most {study.error_bound:.1g})",
        f"epsilon_n  {study.epsilon_n:.10g}",
        f"centre     {study.centre_restitution:.10g}",
        f"impulses   {study.impulse_ratio:.10g}",
        f"beta_0     {'not known' if beta_0 is None else f'{beta_0:.10g}'}",
        f"switches   {'not counted' if study.switches is None else study.switches}",
        f"kappa      {study.kappa:.8g}",
        f"mu/alpha   {study.mu_over_alpha:.8g}",
        f"g_t/g_n    {study.gt_over_gn:.8g}",
        f"psi        {psi:.8g}",
        f"eta        {study.damping:.8g}  (A {study.dissipative_constant_s:.6g} s)",
        f"contact    {study.contact_duration_s:.4g} s",
        f"depth      {study.maximum_compression_m:.4g} m",
        f"force      {study.maximum_normal_force_n:.4g} N",
    ]
    if study.after:
        lines += [
            f"{name}  {', '.join(f'{part:.8g}' for part in vector)}"
            for name, vector in study.after._asdict().items()
        ]
    lines += [f"warning    {caution.text}" for caution in study.warnings]
    return "\n".join([*lines, *study.convention.split("; ")])
