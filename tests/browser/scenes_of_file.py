"""What the page shows where it is one file, and what it says of scenes that take a server."""

OFFERED = {
    "explorer": "face=expert&energy=shown&damping=0.2",
    "plain": "face=plain",
    "second bounce": "bounce=wall_twice&map=switches",
    "compare": "kappa=30&pins=63,1.4,1.358;4.5,1.4,4;18,0.8,0.9,0.3&face=expert",
    "sweep": "sweep=kappa,20,80",
    "projector": "presenting=on&left=force&right=map",
    "panel": "embed=force",
    **{f"lesson, step {step}": f"scene=lesson&step={step}&notes=shown" for step in range(1, 11)},
    "hand-out": "scene=lesson&handout=shown&notes=shown",
}

SERVED = ["spheres", "accuracy", "paper"]
