"""Collisions of pairs of equal solid spheres by YADE, of which this is a script.

``yade -n -x tests/beyond/yade_pairs.py IN OUT``; `other_codes.in_yade` writes IN and reads OUT. All
pairs of a run share a time step; each has a material of its own.
"""

import json
import sys
from pathlib import Path


def main(asked: Path, answer: Path) -> None:
    """Run the pairs; write what the slip at the point of contact is after them."""
    import yade  # noqa: PLC0415 - a module of YADE's own interpreter
    from yade import utils  # noqa: PLC0415 - the same

    laws = {
        "HertzWithLinearShear": (
            yade.Ip2_FrictMat_FrictMat_MindlinPhys(),
            yade.Law2_ScGeom_MindlinPhys_HertzWithLinearShear(nonLin=0),
        ),
        "Mindlin": (
            yade.Ip2_FrictMat_FrictMat_MindlinPhys(),
            yade.Law2_ScGeom_MindlinPhys_Mindlin(),
        ),
        "CundallStrack": (
            yade.Ip2_FrictMat_FrictMat_FrictPhys(),
            yade.Law2_ScGeom_FrictPhys_CundallStrack(),
        ),
    }
    run = json.loads(asked.read_text())
    physics, law = laws[run["law"]]
    scene, radius = yade.O, run["radius"]
    pairs = []
    for place, pair in enumerate(run["pairs"]):
        material = scene.materials.append(
            yade.FrictMat(
                young=pair["young"],
                poisson=pair["poisson"],
                frictionAngle=run["friction_angle"],
                density=run["density"],
            )
        )
        ids = []
        for x, sign in ((0.0, 0.5), (2.0 * radius + pair["gap"], -0.5)):
            centre = (x, 4.0 * radius * place, 0.0)
            ids.append(scene.bodies.append(utils.sphere(centre, radius, material=material)))
            velocity = (sign * run["normal"], -sign * pair["tangential"], 0.0)
            scene.bodies[ids[-1]].state.vel = velocity
        pairs.append(ids)
    scene.engines = [
        yade.ForceResetter(),
        yade.InsertionSortCollider([yade.Bo1_Sphere_Aabb()]),
        yade.InteractionLoop([yade.Ig2_Sphere_Sphere_ScGeom()], [physics], [law]),
        yade.NewtonIntegrator(damping=0),
    ]
    scene.dt = run["step"]
    scene.run(run["steps"], wait=True)
    slip = []
    for ids in pairs:
        one, two = (scene.bodies[body].state for body in ids)
        turning = radius * (one.angVel[2] + two.angVel[2])
        slip.append(two.vel[1] - one.vel[1] - turning)
    answer.write_text(json.dumps(slip))


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:3]))
