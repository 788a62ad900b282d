"""Measured impacts beside the model."""

import re
from pathlib import Path

import pytest

from restitution.studies.spheres.collision import study_scaling
from restitution.studies.spheres.impact import Velocities
from restitution.studies.spheres.materials import MATERIALS

DOCUMENT = (Path(__file__).parents[2] / "docs" / "real-spheres.md").read_text()


def test_kharaz2001_oblique_impacts_beside_the_model():
    (material,) = (m for m in MATERIALS.values() if m.measured)
    listed = re.findall(r"^\| ([\d.]+)° \|(.*)\|$", DOCUMENT, re.MULTILINE)
    for (angle, cells), point in zip(listed, material.measured.points, strict=True):
        study = study_scaling(
            material.contact, Velocities(point.normal_velocity_m_s, point.tangential_velocity_m_s)
        )
        psi, measured, computed = (float(c.replace("−", "-")) for c in cells.split("|"))
        # the digits of the document
        assert float(angle) == pytest.approx(point.angle_deg, abs=0.0051)
        assert psi == pytest.approx(study.psi, abs=0.0051)
        assert measured == pytest.approx(point.epsilon_t, abs=0.00051)
        assert computed == pytest.approx(study.epsilon_t, abs=0.00051)
        assert point.angle_deg < 30 or abs(study.epsilon_t - point.epsilon_t) < 0.03
