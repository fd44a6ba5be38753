"""Units in the files of testing machines."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

_POUND_FORCE = 4.4482216152605  # N, exact
_GRAM_FORCE = 9.80665e-3  # N, exact
_INCH = 0.0254  # m, exact


@dataclass(frozen=True, kw_only=True)
class ColumnKind:
    """The units of one kind of quantity.

    Attributes:
        factors: factor from each unit to SI.
    """

    factors: Mapping[str, float]

    def factor(self, unit: str) -> float | None:
        """Return the factor from a unit, as written in a file, to SI; None if it is not a unit of this kind."""
        spelled = " ".join(unit.replace("²", "^2").replace("**", "^").replace("\N{GREEK SMALL LETTER MU}", "µ").split())
        return self.factors.get(spelled)

    def rule(self) -> str:
        """Return the allowed units, for error messages."""
        return f"need one of {', '.join(self.factors)}"


TIME = ColumnKind(
    factors={"s": 1.0, "ms": 1e-3, "min": 60.0, "h": 3600.0, "sec": 1.0, "Sek": 1.0, "Sek.": 1.0, "sec.": 1.0}
)
LENGTH = ColumnKind(factors={"mm": 1e-3, "m": 1.0, "cm": 1e-2, "µm": 1e-6, "um": 1e-6, "in": _INCH, "inch": _INCH})
AREA = ColumnKind(
    factors={"mm^2": 1e-6, "mm2": 1e-6, "cm^2": 1e-4, "cm2": 1e-4, "m^2": 1.0, "m2": 1.0, "in^2": _INCH**2}
)
FORCE = ColumnKind(
    factors={
        **{"N": 1.0, "kN": 1e3, "mN": 1e-3, "cN": 1e-2, "daN": 10.0, "MN": 1e6},
        **{"gf": _GRAM_FORCE, "kgf": 1e3 * _GRAM_FORCE, "kp": 1e3 * _GRAM_FORCE, "lbf": _POUND_FORCE},
    }
)
STRESS = ColumnKind(
    factors={
        **{"MPa": 1e6, "kPa": 1e3, "Pa": 1.0, "GPa": 1e9, "N/mm^2": 1e6, "N/mm2": 1e6},
        **{"psi": _POUND_FORCE / _INCH**2, "ksi": 1e3 * _POUND_FORCE / _INCH**2},
    }
)
STRAIN = ColumnKind(factors={"%": 1e-2, "mm/mm": 1.0, "m/m": 1.0, "in/in": 1.0, "1": 1.0, "-": 1.0, "‰": 1e-3})
_DEGREE = math.pi / 180
ANGLE = ColumnKind(factors={"deg": _DEGREE, "°": _DEGREE, "rad": 1.0, "mrad": 1e-3, "Grad": _DEGREE, "degree": _DEGREE})
MOMENT = ColumnKind(
    factors={
        **{"N m": 1.0, "Nm": 1.0, "N mm": 1e-3, "Nmm": 1e-3, "N cm": 1e-2, "Ncm": 1e-2, "mN m": 1e-3, "mNm": 1e-3},
        **{"µN m": 1e-6, "µNm": 1e-6, "mN mm": 1e-6, "mNmm": 1e-6, "lbf in": _POUND_FORCE * _INCH},
    }
)
MOMENT_BY_WIDTH = ColumnKind(factors={"N m/m": 1.0, "Nm/m": 1.0, "N mm/mm": 1.0, "Nmm/mm": 1.0, "mN m/m": 1e-3})


def is_unit(text: str) -> bool:
    """Return whether a text is a unit of a quantity of tensile or folding tests."""
    kinds = (TIME, LENGTH, AREA, FORCE, STRESS, STRAIN, ANGLE, MOMENT, MOMENT_BY_WIDTH)
    return any(kind.factor(text) is not None for kind in kinds)
