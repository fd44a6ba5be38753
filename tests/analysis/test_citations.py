import re

import pytest

import forficula as ff
from forficula.analysis.citations import _FEATURES, _PAPERS, citations
from forficula.design import named_designs
from forficula.design.files.kinds import KINDS
from forficula.design.sheets.sheet import METHOD_PAPERS


def keys(design):
    return [citation.publication.key for citation in citations(ff.load_design(design))]


@pytest.mark.parametrize("name", named_designs())
def test_results_of_every_named_design_cite_the_program_and_the_engine_first_and_nothing_twice(name):
    cited = keys(name)
    assert cited[:2] == ["forficula", "todorov2012"]
    assert len(set(cited)) == len(cited)


def test_a_design_cites_the_papers_of_its_pattern_and_of_what_it_is_made_of():
    assert keys("binder2025")[2:] == ["binder2025", "saito2020"]
    assert "gear2003" in keys("binder2025-stored")
    assert keys("miura-sheet")[2:4] == ["schenk2013", "tachi2009"]
    assert {"liu2017", "filipov2017"} <= set(keys("kresling-cell"))
    assert "hoerner1965" not in keys("binder2025")
    assert "chen2015" in keys("thick-miura")


def test_a_wing_in_air_cites_the_source_of_its_drag():
    design = ff.load_design("binder2025", {"medium.density": "1.2 kg/m^3"})
    assert "hoerner1965" in [citation.publication.key for citation in citations(design)]


def test_every_paper_is_cited_by_some_pattern_or_feature_and_every_key_is_a_paper():
    by_patterns = {key for design in KINDS.values() for key in design.papers}
    by_features = {key for key, _, _ in _FEATURES}
    by_methods = {key for papers in METHOD_PAPERS.values() for key in papers}
    assert by_patterns | by_features | by_methods == set(_PAPERS)


def test_bibtex_entries_have_balanced_braces_and_the_fields_of_their_kind():
    for name in named_designs():
        for citation in citations(ff.load_design(name)):
            entry = citation.bibtex
            assert entry.count("{") == entry.count("}")
            assert re.match(r"@(article|book|misc|inproceedings)\{\w+,\n", entry)
            assert ("journal = " in entry) == entry.startswith("@article")
            assert "note = {used for: " in entry


def test_a_publication_with_a_doi_is_printed_with_its_address():
    engine = citations(ff.load_design("binder2025"))[1]
    assert str(engine) == (
        "Todorov, E.; Erez, T.; Tassa, Y. (2012): MuJoCo: a physics engine for model-based control. IEEE/RSJ"
        " International Conference on Intelligent Robots and Systems, 5026-5033. https://doi.org/10.1109/IROS.2012.6386109"
    )
