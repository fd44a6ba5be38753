"""Parts are compared with their design as a whole: features of the design without a part are reported."""

from dataclasses import replace

import pytest

from forficula.make.checks.check_parts import tendon_checks


def with_tendon(parts, bodies):
    """The parts, with an additional tendon in their structure, between the origins of two bodies."""
    structure = parts.structure
    point, tendon = structure.points[0], structure.tendons[0]
    points = tuple(replace(point, name=f"end{body}", body=body) for body in bodies)
    ends = (len(structure.points), len(structure.points) + 1)
    more = replace(tendon, name="another", points=ends, crossing=None, ideal=None)
    built = replace(structure, points=(*structure.points, *points), tendons=(*structure.tendons, more))
    return replace(parts, structure=built)


def test_every_tendon_of_a_wing_has_its_straps(made_section):
    (check,) = tendon_checks(made_section)
    assert (check.ok, check.value, check.limit) == (True, 3.0, 3.0)


@pytest.mark.parametrize(
    ("bodies", "why"),
    [
        # the bars of the first vein, and the proximal ones of two veins, which have no common joint
        ((0, 1), "because fold0 has pegs for tendon0"),
        ((0, 4), "because it crosses no hinge between two bars"),
    ],
)
def test_a_tendon_without_straps_is_reported(made_section, bodies, why):
    (check,) = tendon_checks(with_tendon(made_section, bodies))
    assert (check.ok, check.value, check.limit) == (False, 3.0, 4.0)
    assert f"no straps are made for another, {why}" in check.text


def test_a_single_joint_needs_no_straps_for_other_tendons(made_joint):
    assert list(tendon_checks(made_joint)) == []
