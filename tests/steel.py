"""Two equal steel spheres of 2 cm, as a body of the service and as options of the command line."""

SPHERE = {
    "radius_m": 0.02,
    "density_kg_m3": 7850,
    "youngs_modulus_pa": 2.1e11,
    "poisson_ratio": 0.3,
}
PAIR = {
    "body_1": SPHERE,
    "body_2": SPHERE,
    "friction_coefficient": 0.4,
    "tangential_stiffness_n_per_m": "mindlin",
    "impact": {"normal_velocity_m_s": 1, "tangential_velocity_m_s": 0.5},
}
TOLD = [
    "--radius", "0.02", "--density", "7850", "--youngs-modulus", "2.1e11",
    "--poisson-ratio", "0.3", "--friction", "0.4",
]  # fmt: skip
