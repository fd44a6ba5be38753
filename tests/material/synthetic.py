"""Simulated tensile tests with a known law, and their files in the formats of testing machines."""

from itertools import pairwise

import numpy as np

from forficula.material.sample_tests import AREA, LENGTH, SPEED, cyclic_test
from forficula.material.sample_tests import rubber_test as tpu

__all__ = ["AREA", "LENGTH", "SPEED", "cyclic_test", "tpu"]

TO_MM, TO_MM2 = 1e3, 1e6


def few_rows():
    """A test that is quickly written and read."""
    return cyclic_test(lambda strain, _: 4.8e6 * strain, cycles=2, samples=10, noise=1e4)


def xpert_text(
    test, *, delimiter="\t", decimal=".", german=True, force_unit="N", travel="travel", size=True, in_names=False
):
    """An export of ZwickRoell testXpert III: properties, names, units, numbers."""
    force_scale = {"N": 1.0, "kN": 1e-3, "MPa": 1e-6 / test.area}[force_unit]
    names = {
        True: {"time": "Prüfzeit", "force": "Standardkraft", "travel": "Standardweg", "strain": "Dehnung"},
        False: {"time": "Test time", "force": "Standard force", "travel": "Standard travel", "strain": "Strain"},
    }[german]
    properties = [
        ("Prüfinstitut", "Labor für Prüftechnik") if german else ("Test institute", "Laboratory"),
        ("Datum/Uhrzeit" if german else "Date/Clock time", 44335.4, ""),
        ("Temperatur", 22, "°C"),
    ]
    if size:
        length = "Messlänge Standardweg" if german else "Gage length, standard travel"
        properties += [(length, f"{test.length * TO_MM:.1f}", "mm"), ("S0", f"{test.area * TO_MM2:.2f}", "mm²")]
    lines = [[quoted(label), number(str(value), decimal), *map(quoted, unit)] for label, value, *unit in properties]
    columns = [(names["time"], "s", test.time), (names["force"], force_unit, test.force * force_scale)]
    if travel == "travel":
        columns.append((names["travel"], "mm", test.extension * TO_MM))
    columns.append((names["strain"], "%", test.strain * 100))
    return table(columns, lines, delimiter, decimal, quote_names=True, in_names=in_names)


def bluehill_text(test, *, decimal=".", german=False, force_unit="N", properties=True):
    """An export of Instron Bluehill: `type : name,value,units`, a blank line, names, units in brackets, numbers."""
    names = ("Zeit", "Verfahrweg", "Kraft") if german else ("Time", "Extension", "Load")
    area, length = number(f"{test.area * TO_MM2:.2f}", decimal), number(f"{test.length * TO_MM:.1f}", decimal)
    head = ["Specimen properties : Geometry,Rectangular", f'Specimen properties : Area,"{area}",mm^2']
    lines = [*head, f'Specimen properties : Length,"{length}",mm', ""] if properties else []
    scale = {"N": 1.0, "kN": 1e-3, "lbf": 1 / 4.4482216152605}[force_unit]
    values = np.column_stack([test.time, test.extension * TO_MM, test.force * scale])
    rows = [",".join(f'"{number(f"{value:.9g}", decimal)}"' for value in row) for row in values]
    return "\r\n".join([*lines, ",".join(names), f"(s),(mm),({force_unit})", *rows, ""])


def plain_text(test, *, delimiter=",", decimal=".", pattern="{name} [{unit}]"):
    """A table with units in its column names."""
    columns = [("time", "s", test.time), ("extension", "mm", test.extension * TO_MM), ("force", "N", test.force)]
    named = [(pattern.format(name=name, unit=unit), None, values) for name, unit, values in columns]
    return table(named, [], delimiter, decimal)


def table(columns, lines, delimiter, decimal, *, quote_names=False, in_names=False):
    """Lines, names, units where there are any, numbers of nine digits."""
    names, units, values = zip(*columns, strict=True)
    if in_names:
        names, units = [f"{name} [{unit}]" for name, unit in zip(names, units, strict=True)], [None]
    quote = quoted if quote_names else str
    head = [*lines, [quote(name) for name in names], *([[quote(unit) for unit in units]] if units[0] else [])]
    rows = [[number(f"{value:.9g}", decimal) for value in row] for row in np.column_stack(values)]
    return "\n".join(delimiter.join(row) for row in [*head, *rows]) + "\n"


def quoted(text):
    return f'"{text}"'


def number(text, decimal):
    return text.replace(".", decimal)


def loading_program(steps, *, acceleration=0.05):
    """Knots of a test, shape (knot,) each: time in s, strain rate in 1/s, which runs straight between knots.

    `steps` are pairs of a strain to go to and the rate to go there with, 1/s, or of None and the seconds of a hold;
    every change of rate takes `acceleration` of the shorter of the two steps beside it.
    """
    ways, strain = [], 0.0
    for target, value in steps:
        duration = value if target is None else abs(target - strain) / value
        ways.append((duration, 0.0 if target is None else (target - strain) / duration))
        strain = strain if target is None else target
    times, rates, start = [0.0], [0.0], 0.0
    for (duration, rate), (after, following) in zip(ways, [*ways[1:], (np.inf, 0.0)], strict=True):
        change = acceleration * min(duration, after)
        if len(times) == 1:
            times, rates = [0.0, change], [0.0, rate]
        start += duration
        # centred at the corner, so that the strain arrives where it should, but for the start from rest
        times += [start - change / 2, start + change / 2]
        rates += [rate, following]
    return np.array(times), np.array(rates)


def sampled(knots, *, rows=25):
    """Times at which a program is sampled, s: `rows` in each step, denser after its start, 6 where it turns."""
    ends = knots[0]
    within = [
        begin + (end - begin) * (np.geomspace(1, 40, rows + 1) - 1) / 39 if index % 2 else np.linspace(begin, end, 7)
        for index, (begin, end) in enumerate(pairwise(ends))
    ]
    return np.unique(np.concatenate(within))


def viscoelastic_stress(knots, time, moduli, *, viscosity=0.0, branches=()):
    """Strain and stress in Pa of a spring, a damper and Maxwell branches, closed forms, shape (sample,) each.

    Where the rate is r + a t, dq/dt = E r(t) - q / T has the solution q = E T (r(t) - a T) + C exp(-t / T).
    """
    strain, stress = np.zeros_like(time), np.zeros_like(time)
    reached, stresses = 0.0, [0.0 for _ in branches]
    ends = zip(knots[0][:-1], knots[0][1:], knots[1][:-1], knots[1][1:], strict=True)
    for begin, end, rate, following in ends:
        within = (time >= begin) & (time <= end)
        since = np.append(time[within], end) - begin
        slope = (following - rate) / (end - begin)
        rates = rate + slope * since
        strains = reached + rate * since + slope * since**2 / 2
        total = viscosity * rates + sum(item * strains ** (power + 1) for power, item in enumerate(moduli))
        for index, (modulus, relaxation) in enumerate(branches):
            steady = modulus * relaxation * (rates - slope * relaxation)
            first = modulus * relaxation * (rate - slope * relaxation)
            course = steady + (stresses[index] - first) * np.exp(-since / relaxation)
            total, stresses[index] = total + course, course[-1]
        strain[within], stress[within], reached = strains[:-1], total[:-1], strains[-1]
    return strain, stress
