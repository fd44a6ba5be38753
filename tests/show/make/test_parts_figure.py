"""Figures of parts to make."""

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.make.files.bill import bill_of
from forficula.make.make_parts import make_parts
from forficula.show.folder.parts_folder import BILL_FILE, write_parts
from forficula.show.folder.presentation import drawings_of, folder_drawings, write_figure
from forficula.show.make.painted_parts import placed_parts
from forficula.show.make.part_facts import mass_text, part_masses, total_mass, value_text
from forficula.show.make.part_looks import part_looks
from forficula.show.make.parts_figure import draw_parts
from forficula.show.page.data.parts_data import parts_data
from forficula.show.page.parts_page import parts_page
from forficula.show.style import COLUMN_WIDTH, save_figure
from tests.show.legible import check_words


@pytest.fixture(scope="module")
def joint():
    return make_parts("binder2025-joint", "joint")


@pytest.fixture(scope="module")
def section():
    return make_parts("binder2025", "section")


def test_words_of_the_figure_of_parts_can_be_read(joint, section):
    check_words(drawings_of(joint)["parts"](COLUMN_WIDTH), COLUMN_WIDTH)
    check_words(draw_parts(section, COLUMN_WIDTH), COLUMN_WIDTH)


@pytest.mark.usefixtures("undrawn")
def test_the_figure_is_drawn_again_from_what_a_folder_holds(joint, tmp_path):
    write_parts(joint, (), tmp_path)
    write_figure(tmp_path, "parts", tmp_path / "again.png", COLUMN_WIDTH)
    save_figure(draw_parts(joint, COLUMN_WIDTH), tmp_path / "first.png")
    assert (tmp_path / "again.png").read_bytes() == (tmp_path / "first.png").read_bytes()
    (tmp_path / BILL_FILE).write_text('{"parts": [{"part": "wheel"}]}')
    with pytest.raises(InputError, match="its bill is not of its design"):
        folder_drawings(tmp_path)


def test_a_folder_of_a_sheet_has_the_figure_of_the_sheet_alone(tmp_path):
    write_parts(make_parts("letter-fold"), (), tmp_path)
    assert list(folder_drawings(tmp_path)) == ["sheet"]


@pytest.mark.parametrize("which", ["lower", "upper"])
def test_at_a_stop_faces_of_both_halves_lie_on_one_another_and_half_way_none_do(joint, which):
    (layout,) = joint.joints
    axis = layout.frame[:, 1]

    def meet(angle):
        halves = []
        for placed in placed_parts(joint, angle):
            corners = placed.mesh.points[placed.mesh.triangles[: placed.mesh.stops]]
            normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
            # side of the axis
            off = (corners.mean(axis=1) - layout.origin) @ (np.eye(3) - np.outer(axis, axis))
            halves.append([item / np.linalg.norm(item, axis=1)[:, None] for item in (normals, off)])
        (one, current), (other, present) = (half for half in halves if len(half[0]))
        return bool(((one @ other.T < -1 + 1e-9) & (current @ present.T > 1 - 1e-6)).any())

    assert meet(getattr(layout, which))
    assert not meet((layout.lower + layout.upper) / 2)


def test_bars_of_different_roles_have_different_colours(section):
    looks, numbers = part_looks(section)
    assert [look.name for look in looks] == ["proximal bar", "distal bar", "pin", "strap", "hub", "root"]
    assert len({look.colour for look in looks}) == len(looks)
    assert all(looks[look].kind == part.kind for part, look in zip(section.parts, numbers, strict=True))


def test_values_have_the_units_of_drawings():
    assert value_text(4e-4, "m") == "0.4 mm"
    assert value_text(1e-10, "m^3") == "0.1 mm³"
    assert value_text(-np.pi, "rad") == "−180 deg"
    assert value_text(np.nan, "N") == "–"
    assert value_text(2.5, "") == "2.5"
    assert mass_text(None) == "not known"
    assert mass_text(0.00029999) == "0.300 g"


def test_masses_of_straps_are_those_of_their_printed_layers(joint):
    """Volume of the mesh times the density, times the share that whole layers print: 2.4 of 2.5 mm."""
    (strap,) = (part for part in joint.parts if part.kind == "strap")
    mass = 2.4 / 2.5 * 1150 * strap.volume
    (row,) = (row for row in bill_of(joint) if row.part == strap.name)
    assert row.mass == pytest.approx(mass, rel=1e-9)
    assert part_masses(joint)[strap.name] == row.mass
    assert f"<td>{mass_text(mass)}</td>" in parts_page(joint, ())
    assert mass_text(mass) in [fact for part in parts_data(joint, None)["parts"] for fact in part["facts"]]
    others = sum(part.count * part.mass for part in joint.parts if part is not strap)
    assert total_mass(joint) == pytest.approx(others + strap.count * mass, rel=1e-9)
