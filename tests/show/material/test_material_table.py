import csv
import io

import pytest
from rich.console import Console

from forficula.analysis.sizing import size_tendons
from forficula.design import load_design
from forficula.material.law.law_file import load_law
from forficula.material.law.material_law import MaterialLaw
from forficula.show.material.material_table import material_table
from forficula.show.material.size_table import size_table, sizes_csv


def printed(content):
    console = Console(width=110)
    with console.capture() as capture:
        console.print(content)
    return capture.get()


def line(text, start):
    return next(splitline for splitline in text.splitlines() if splitline.startswith(start))


@pytest.mark.parametrize("which", ["tpu_material", "elastic_material", "lawless_material"])
def test_every_material_reads_as_sentences_and_numbers(request, which):
    text = printed(material_table(request.getfixturevalue(which)))
    assert "None" not in text
    assert "nan" not in text.split()
    assert text.rstrip().endswith(".")
    assert "Cycles, medians over specimens" in text


def test_the_table_has_the_moduli_with_their_unit_and_the_interval_of_the_law(elastic_material):
    text = printed(material_table(elastic_material))
    assert text.startswith("elastic: 1 specimen, length 60 mm, area 5 mm², cycles 2 to 3\n")
    assert "Moduli by class of strain (MPa): median [quartiles]" in text
    assert line(text, "50 to 60").split()[3] == "4.80"
    words = line(text, "modulus.linear").split()
    low, high = float(words[3]), float(words[5])
    assert low < 4.8 < high


def test_the_table_says_by_how_much_specimens_differ_and_over_which_rates_they_were_pulled(tpu_material):
    text = " ".join(printed(material_table(tpu_material)).split())
    amplitudes = [residual.amplitude for residual in tpu_material.fit.residuals]
    assert f"differ from the law's by −{100 * (1 - min(amplitudes)):.2f} %" in text
    assert f"standard deviation {100 * tpu_material.fit.scatter:.2f} %" in text
    # 10 mm/min by 60 mm
    assert "lowest_strain_rate 0.002778 1/s" in text
    assert "highest_strain_rate 0.002778 1/s" in text


def test_one_specimen_has_no_others_to_differ_from(elastic_material):
    assert "amplitude" not in printed(material_table(elastic_material))


def test_what_the_data_cannot_determine_is_a_sentence(tpu_material):
    text = " ".join(printed(material_table(tpu_material)).split())
    assert "one rate only" in text
    assert "The first cycle of every specimen is left out of all values" in text


def test_without_a_law_there_is_its_reason(lawless_material):
    text = printed(material_table(lawless_material))
    assert "There is no law: too few rows." in text
    assert "95 % interval" not in text.split("Drift over the cycles")[1].split("\n\n")[1]


def test_sizes_of_a_linear_and_of_a_nonlinear_tendon(reference):
    law = load_law("tpu-82a")
    text = printed(size_table(law, size_tendons(reference, law, [1000.0, 6000.0])))
    assert "tpu-82a, length 60 mm, of the specimens of tpu-82a" in text
    assert line(text, "10 N/cm").split()[2:4] == ["12.5", "mm²"]
    assert "within the 100 % up to which tpu-82a was measured" in text
    assert "mean stiffness" not in text
    grown = MaterialLaw(name="grown", moduli=(4e6, 0.0, 1e6), residual_strain=0.1)
    text = printed(size_table(grown, size_tendons(reference, grown, [1000.0])))
    assert "mean stiffness" in text
    assert "The material is permanently 10 % longer" in text
    assert "the law does not report the strain up to which it was measured" in " ".join(text.split())


def test_sizes_call_the_structure_by_its_word():
    law = load_law("tpu-82a")
    text = printed(size_table(law, size_tendons(load_design("letter-fold"), law, [1000.0], length=1.0)))
    assert "The tendon is slack in the flat structure." in text
    assert "wing" not in text


def test_sizes_are_written_in_si_and_what_is_absent_is_empty(reference):
    sizes = size_tendons(reference, load_law("tpu-82a"), [1000.0], length=0.15)
    slack, measured = csv.DictReader(io.StringIO(sizes_csv(sizes)))
    assert slack["area_by_mean_stiffness_to_flat_m2"] == ""
    # A = k L / E, 10 N/cm, 9 cm, 4.8 MPa
    assert float(measured["area_m2"]) == pytest.approx(1000 * 0.09 / 4.8e6)
    assert measured["flat_strain_beyond_measured"] == "false"
