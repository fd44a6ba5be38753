import json
import re

import pytest

from forficula.errors import InputError
from forficula.material.law.law_file import load_law
from forficula.material.law.law_keys import show_value
from forficula.material.law.law_summary import known_values
from forficula.show.folder.material_folder import write_material
from forficula.show.page.parts.html import escaped

pytestmark = pytest.mark.usefixtures("no_figures")

FILES = [
    *("cycles.png", "drift.png", "figures", "fit.png", "material.json", "modulus.png", "report.html"),
    "tendon_law.toml",
]


def names(folder):
    return sorted(path.name for path in folder.iterdir())


@pytest.fixture
def written(tpu_material, tmp_path):
    folder = tmp_path / "deep" / "tpu"
    write_material(tpu_material, folder)
    return folder


def test_a_material_leaves_its_files_and_its_law_can_be_loaded(tpu_material, written):
    assert names(written) == FILES
    assert load_law(written / "tendon_law.toml") == tpu_material.law

    def refuse(word):
        raise AssertionError(f"{word} is not JSON")

    content = json.loads((written / "material.json").read_text("utf-8"), parse_constant=refuse)
    assert content["material"] == "tpu"
    assert {"forficula", "numpy", "scipy"} == set(content["versions"])


def test_the_page_of_a_material_shows_the_fit_with_its_residual_and_every_value_of_the_law(tpu_material, written):
    page = (written / "report.html").read_text("utf-8")
    assert page.count("<img ") == page.count('alt="') == 4
    assert re.search(r'<section id="fit">.*?alt="Measured stress of tpu over strain', page, re.S)
    rows = dict(re.findall(r'<tr><th scope="row">([^<]*)</th><td>([^<]*)</td>', page))
    for value in known_values(tpu_material.law):
        assert rows[value.key] == show_value(value.key, value.value).replace("-", "−")
    left = f"residual {tpu_material.fit.misfit / 1e3:.3g} kPa"
    assert left in page
    for remark in tpu_material.remarks:
        assert escaped(remark.rstrip("."))[1:] in page
    assert page.count("<script") == 1  # saves figures


@pytest.mark.usefixtures("undrawn")
def test_without_a_law_the_law_of_an_earlier_material_goes(tpu_material, lawless_material, tmp_path):
    write_material(tpu_material, tmp_path)
    (tmp_path / "mine.txt").write_text("stays", "utf-8")
    write_material(lawless_material, tmp_path)
    assert names(tmp_path) == sorted({*FILES, "mine.txt"} - {"fit.png", "tendon_law.toml"})
    assert 'id="fit"' not in (tmp_path / "report.html").read_text("utf-8")
    assert {path.stem for path in (tmp_path / "figures").iterdir()} == {"cycles", "drift", "modulus"}
    content = json.loads((tmp_path / "material.json").read_text("utf-8"))
    assert (content["law"], content["fit"]) == (None, None)


def test_all_files_of_a_material_are_written_or_none(tpu_material, tmp_path):
    (tmp_path / "modulus.png").mkdir()
    with pytest.raises(InputError, match=r"modulus\.png"):
        write_material(tpu_material, tmp_path)
    assert names(tmp_path) == ["modulus.png"]
