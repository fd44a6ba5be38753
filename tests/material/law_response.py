"""The stress of a law over a whole strain history, from the functions that fits and simulations use."""

from dataclasses import dataclass

import numpy as np

from forficula.material.law.material_law import known_moduli
from forficula.material.law.softening import spring_energy, spring_stress
from forficula.material.law.stress import branch_stress, set_history


@dataclass(frozen=True, kw_only=True)
class StressHistory:
    """Part by part, Pa, each of shape (samples,), the branches (branches, samples); the set is a strain."""

    spring: np.ndarray
    damper: np.ndarray
    branches: np.ndarray
    set_strain: np.ndarray

    @property
    def total(self):
        return self.spring + self.damper + self.branches.sum(axis=0)

    @property
    def pull(self):
        """Stress of a specimen as a testing machine measures it; the specimen buckles instead of pushing."""
        return np.maximum(self.total, 0.0)


def stress_of(law, time, strain):
    """Of a material at rest before the first sample; between two samples the strain runs straight."""
    time, strain = np.asarray(time, dtype=float), np.asarray(strain, dtype=float)
    moduli = known_moduli(law)
    lowest = set_history(strain, law.residual_strain, law.yield_strain)
    if law.softening is None:
        spring = spring_stress(moduli, strain - lowest)
    else:
        spring = softened_stress(moduli, law.softening, np.maximum(strain - lowest, 0.0))
    branches = [branch_stress(branch, time, strain) for branch in law.branches]
    first, second, third = law.viscosity or (0.0, 0.0, 0.0)
    rate = np.gradient(strain, time)
    return StressHistory(
        spring=spring,
        damper=rate * (first + np.abs(rate) * (second + np.abs(rate) * third)),
        branches=np.array(branches).reshape(len(branches), len(time)),
        set_strain=lowest,
    )


def softened_stress(moduli, softening, strain):
    """Of a spring that begins virgin; between two samples the largest energy is taken at the sample."""
    energy = spring_energy(moduli, strain)
    return softening.share(np.maximum.accumulate(energy), energy) * spring_stress(moduli, strain)
