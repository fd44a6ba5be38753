import json

import pytest

from forficula.errors import InputError
from forficula.material.law.law_file import load_law
from forficula.show.folder.material_folder import write_material

FILES = ["cycles.png", "drift.png", "figures", "fit.png", "material.json", "modulus.png", "tendon_law.toml"]


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_a_material_leaves_its_files_and_its_law_can_be_loaded(tpu_material, tmp_path):
    write_material(tpu_material, tmp_path / "deep" / "tpu")
    assert names(tmp_path / "deep" / "tpu") == FILES
    assert load_law(tmp_path / "deep" / "tpu" / "tendon_law.toml") == tpu_material.law

    def refuse(word):
        raise AssertionError(f"{word} is not JSON")

    content = json.loads((tmp_path / "deep/tpu/material.json").read_text("utf-8"), parse_constant=refuse)
    assert content["material"] == "tpu"
    assert {"forficula", "numpy", "scipy"} == set(content["versions"])


def test_without_a_law_the_law_of_an_earlier_material_goes(tpu_material, lawless_material, tmp_path):
    write_material(tpu_material, tmp_path)
    (tmp_path / "mine.txt").write_text("stays", "utf-8")
    write_material(lawless_material, tmp_path)
    assert names(tmp_path) == ["cycles.png", "drift.png", "figures", "material.json", "mine.txt", "modulus.png"]
    assert {path.stem for path in (tmp_path / "figures").iterdir()} == {"cycles", "drift", "modulus"}
    content = json.loads((tmp_path / "material.json").read_text("utf-8"))
    assert (content["law"], content["fit"]) == (None, None)


def test_a_material_leaves_all_files_or_none(tpu_material, tmp_path):
    (tmp_path / "modulus.png").mkdir()
    with pytest.raises(InputError, match=r"modulus\.png"):
        write_material(tpu_material, tmp_path)
    assert names(tmp_path) == ["modulus.png"]
