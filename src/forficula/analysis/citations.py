"""Publications to cite for results of a design: the program, the engine and the papers whose formulas it uses."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import metadata

from forficula.design import Design
from forficula.structure import Structure, structure_of

# field of a BibTeX entry that says where it was published, by the kind of the entry
_PUBLISHED = {"article": "journal", "inproceedings": "booktitle", "book": "publisher", "misc": "howpublished"}


@dataclass(frozen=True, kw_only=True)
class Publication:
    """A publication or a program.

    Attributes:
        key: by which BibTeX refers to it.
        kind: of the BibTeX entry, such as "article".
        authors: separated by " and ", family name first.
        year: of publication; "" where a program has versions instead.
        title: of the work.
        published: journal, proceedings or publisher, or the version of a program.
        volume: of the journal, with the issue in brackets where pages are counted by issue.
        pages: first and last, or the number of the article.
        doi: digital object identifier; "" where there is none.
    """

    key: str
    kind: str = "article"
    authors: str
    year: str = ""
    title: str
    published: str
    volume: str = ""
    pages: str = ""
    doi: str = ""


@dataclass(frozen=True, kw_only=True)
class Citation:
    """A publication and what of a design it stands for.

    Attributes:
        publication: to cite.
        used_for: what the design takes from it.
    """

    publication: Publication
    used_for: str

    def __str__(self) -> str:
        work = self.publication
        year = f" ({work.year})" if work.year else ""
        place = ", ".join(part for part in (f"{work.published} {work.volume}".rstrip(), work.pages) if part)
        doi = f" https://doi.org/{work.doi}" if work.doi else ""
        authors = work.authors.strip("{}").replace(" and ", "; ")
        return f"{authors}{year}: {work.title}. {place}.{doi}"

    @property
    def bibtex(self) -> str:
        """The publication as an entry of a BibTeX file."""
        work = self.publication
        fields = {
            "author": work.authors,
            "year": work.year,
            "title": "{" + work.title + "}",
            _PUBLISHED[work.kind]: work.published,
            "volume": work.volume,
            "pages": work.pages.replace("-", "--"),
            "doi": work.doi,
            "note": f"used for: {self.used_for}",
        }
        lines = [f"  {name} = {{{value}}}," for name, value in fields.items() if value]
        return "\n".join([f"@{work.kind}{{{work.key},", *lines, "}"])


_PAPERS = {
    paper.key: paper
    for paper in (
        Publication(
            key="bergou2006",
            kind="inproceedings",
            authors="Bergou, M. and Wardetzky, M. and Harmon, D. and Zorin, D. and Grinspun, E.",
            year="2006",
            title="A quadratic bending model for inextensible surfaces",
            published="Eurographics Symposium on Geometry Processing",
            pages="227-230",
            doi="10.2312/SGP/SGP06/227-230",
        ),
        Publication(
            key="binder2025",
            authors="Binder and Costi and Izzo and Seidl",
            year="2025",
            title="Quantifying Nature's Bistability: Simulation of Earwig Fan Folding",
            published="Biomimetics",
            volume="11(1)",
            pages="9",
            doi="10.3390/biomimetics11010009",
        ),
        Publication(
            key="cai2015",
            authors="Cai, J. and Deng, X. and Zhang, Y. and Feng, J. and Zhou, Y.",
            year="2015",
            title="Bistable behavior of the cylindrical origami structure with Kresling pattern",
            published="Journal of Mechanical Design",
            volume="137(6)",
            pages="061406",
            doi="10.1115/1.4030158",
        ),
        Publication(
            key="chen2015",
            authors="Chen, Y. and Peng, R. and You, Z.",
            year="2015",
            title="Origami of thick panels",
            published="Science",
            volume="349",
            pages="396-400",
            doi="10.1126/science.aab2870",
        ),
        Publication(
            key="chen2016",
            authors="Chen, Y. and Feng, H. and Ma, J. and Peng, R. and You, Z.",
            year="2016",
            title="Symmetric waterbomb origami",
            published="Proceedings of the Royal Society A",
            volume="472",
            pages="20150846",
            doi="10.1098/rspa.2015.0846",
        ),
        Publication(
            key="edmondson2014",
            kind="inproceedings",
            authors="Edmondson, B. J. and Lang, R. J. and Magleby, S. P. and Howell, L. L.",
            year="2014",
            title="An offset panel technique for thick rigidly foldable origami",
            published="ASME International Design Engineering Technical Conferences",
            pages="V05BT08A054",
        ),
        Publication(
            key="faber2018",
            authors="Faber, J. A. and Arrieta, A. F. and Studart, A. R.",
            year="2018",
            title="Bioinspired spring origami",
            published="Science",
            volume="359",
            pages="1386-1391",
            doi="10.1126/science.aap7753",
        ),
        Publication(
            key="filipov2017",
            authors="Filipov, E. T. and Liu, K. and Tachi, T. and Schenk, M. and Paulino, G. H.",
            year="2017",
            title="Bar and hinge models for scalable analysis of origami",
            published="International Journal of Solids and Structures",
            volume="124",
            pages="26-45",
            doi="10.1016/j.ijsolstr.2017.05.028",
        ),
        Publication(
            key="gear2003",
            authors="Gear, C. W. and Kevrekidis, I. G.",
            year="2003",
            title="Projective methods for stiff differential equations: problems with gaps in their eigenvalue"
            " spectrum",
            published="SIAM Journal on Scientific Computing",
            volume="24",
            pages="1091-1106",
            doi="10.1137/S1064827501388157",
        ),
        Publication(
            key="guest1994",
            authors="Guest, S. D. and Pellegrino, S.",
            year="1994",
            title="The folding of triangulated cylinders, part I: geometric considerations",
            published="Journal of Applied Mechanics",
            volume="61",
            pages="773-777",
            doi="10.1115/1.2901553",
        ),
        Publication(
            key="hoerner1965",
            kind="book",
            authors="Hoerner, S. F.",
            year="1965",
            title="Fluid-dynamic drag",
            published="published by the author",
        ),
        Publication(
            key="ku2015",
            kind="inproceedings",
            authors="Ku, J. S. and Demaine, E. D.",
            year="2015",
            title="Folding flat crease patterns with thick materials",
            published="ASME International Design Engineering Technical Conferences",
            pages="DETC2015-48039",
        ),
        Publication(
            key="lechenault2014",
            authors="Lechenault, F. and Thiria, B. and Adda-Bedia, M.",
            year="2014",
            title="Mechanical response of a creased sheet",
            published="Physical Review Letters",
            volume="112",
            pages="244301",
            doi="10.1103/PhysRevLett.112.244301",
        ),
        Publication(
            key="liu2017",
            authors="Liu, K. and Paulino, G. H.",
            year="2017",
            title="Nonlinear mechanics of non-rigid origami: an efficient computational approach",
            published="Proceedings of the Royal Society A",
            volume="473",
            pages="20170348",
            doi="10.1098/rspa.2017.0348",
        ),
        Publication(
            key="ogden1999",
            authors="Ogden, R. W. and Roxburgh, D. G.",
            year="1999",
            title="A pseudo-elastic model for the Mullins effect in filled rubber",
            published="Proceedings of the Royal Society A",
            volume="455",
            pages="2861-2877",
            doi="10.1098/rspa.1999.0431",
        ),
        Publication(
            key="saito2020",
            authors="Saito, K. and Pérez-de la Fuente, R. and Arimoto, K. and Seong, Y. A. and Aonuma, H."
            " and Niiyama, R. and You, Z.",
            year="2020",
            title="Earwig fan designing: biomimetic and evolutionary biology applications",
            published="Proceedings of the National Academy of Sciences",
            volume="117",
            pages="17622-17626",
            doi="10.1073/pnas.2005769117",
        ),
        Publication(
            key="schenk2013",
            authors="Schenk, M. and Guest, S. D.",
            year="2013",
            title="Geometry of Miura-folded metamaterials",
            published="Proceedings of the National Academy of Sciences",
            volume="110",
            pages="3276-3281",
            doi="10.1073/pnas.1217998110",
        ),
        Publication(
            key="tachi2009",
            authors="Tachi, T.",
            year="2009",
            title="Generalization of rigid-foldable quadrilateral-mesh origami",
            published="Journal of the International Association for Shell and Spatial Structures",
            volume="50",
            pages="173-179",
        ),
        Publication(
            key="tachi2011",
            kind="inproceedings",
            authors="Tachi, T.",
            year="2011",
            title="Rigid-foldable thick origami",
            published="Origami 5, CRC Press",
            pages="253-264",
        ),
    )
}
_ENGINE = Publication(
    key="todorov2012",
    kind="inproceedings",
    authors="Todorov, E. and Erez, T. and Tassa, Y.",
    year="2012",
    title="MuJoCo: a physics engine for model-based control",
    published="IEEE/RSJ International Conference on Intelligent Robots and Systems",
    pages="5026-5033",
    doi="10.1109/IROS.2012.6386109",
)


def _softens(structure: Structure) -> bool:
    return any(tendon.material is not None and tendon.material.softening is not None for tendon in structure.tendons)


def _bends(structure: Structure) -> bool:
    return any(hinge.flaps is not None for hinge in structure.hinges)


# key of a publication, its use, and whether a structure has the feature that uses it; independent of the pattern
_FEATURES: tuple[tuple[str, str, Callable[[Structure], bool]], ...] = (
    ("liu2017", "statics of creases between flaps and of elastic bars", _bends),
    ("filipov2017", "stiffness of the elastic bars that stand for facets", lambda structure: bool(structure.springs)),
    ("bergou2006", "bending stiffness of facets between creases", _bends),
    ("lechenault2014", "stiffness of creases for which the design gives none", _bends),
    ("hoerner1965", "drag of panels in air or water", lambda structure: structure.medium is not None),
    ("ogden1999", "softening of tendons by the largest strain so far", _softens),
    (
        "gear2003",
        "time steps over long stages in which only Maxwell branches relax",
        lambda structure: any(
            branches
            for branches in (
                *(tendon.law.branches for tendon in structure.tendons),
                *(hinge.branches for hinge in structure.hinges),
            )
        ),
    ),
)


def citations(design: Design) -> tuple[Citation, ...]:
    """List the publications to cite for results of a design.

    Returns:
        The program and the engine first, then the publications of the pattern and of the model, each once.
    """
    structure = structure_of(design)
    result = {
        _software(): "all results",
        _ENGINE: "simulated runs",
        **{_PAPERS[key]: used_for for key, used_for in {**design.papers, **design.method_papers}.items()},
    }
    for key, used_for, has in _FEATURES:
        if has(structure):
            result.setdefault(_PAPERS[key], used_for)
    return tuple(Citation(publication=publication, used_for=used_for) for publication, used_for in result.items())


def _software() -> Publication:
    return Publication(
        key="forficula",
        kind="misc",
        authors="{The forficula developers}",
        title="forficula: bistable folding structures",
        published=f"version {metadata.version('forficula')}",
    )
