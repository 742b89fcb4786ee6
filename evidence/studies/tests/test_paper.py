"""The paper uses what is computed for it, and cites what it lists."""

import re
from pathlib import Path

import pytest

from evidence.studies.paper import FIGURES, NUMBERS, TABLES, escaped, tabular
from evidence.studies.study import load

TEXT = (Path(__file__).parents[3] / "docs" / "paper" / "paper.tex").read_text(encoding="utf-8")


def test_every_number_table_and_figure_is_used_and_there():
    assert {*re.findall(r"\\num(\w+)", TEXT)} == {*NUMBERS}
    assert {*re.findall(r"\\tab(\w+)", TEXT)} == {*TABLES}
    assert {*re.findall(r"\\includegraphics\[[^]]*\]\{([\w-]+)\}", TEXT)} == {
        "-".join(one) for one in FIGURES
    }
    for study, place in (*NUMBERS.values(), *TABLES.values()):
        assert place in load(study).texts
    for study, name in FIGURES:
        assert name in load(study).pictures


def test_every_source_is_cited_and_every_citation_has_a_source():
    cited = {key for keys in re.findall(r"\\cite\{([^}]+)\}", TEXT) for key in keys.split(",")}
    assert cited == set(re.findall(r"\\bibitem\{([^}]+)\}", TEXT))
    for link, shown in re.findall(r"\\href\{https://doi\.org/([^}]+)\}\{doi:([^}]+)\}", TEXT):
        assert link == shown


def test_every_reference_has_a_label():
    labels = re.findall(r"\\label\{([^}]+)\}", TEXT)
    assert len(labels) == len(set(labels))
    assert set(re.findall(r"\\ref\{([^}]+)\}", TEXT)) <= set(labels)


@pytest.mark.parametrize(
    ("text", "tex"),
    [
        ("Î = 1e-4 and 3e-12", r"Î = $10^{-4}$ and $3\cdot10^{-12}$"),
        ("μs = 0.72, -0.9 Î^⅓, I_zz", r"$\mu_s$ = 0.72, $-$0.9 $\hat I^{1/3}$, $\hat I_{zz}$"),
        ("θ_P at 5 %", r"$\theta_P$ at 5\,\%"),
    ],
)
def test_plain_letters_become_those_of_tex(text, tex):
    assert escaped(text) == tex


def test_a_table_has_the_cells_of_its_page():
    lines = tabular("jam", "rim bounds").splitlines()
    rows = load("jam").texts["rim bounds"]()
    assert len([line for line in lines if line.endswith(r"\\")]) == len(rows) - 1
    assert lines[4].split(" & ")[0] == "0.1"
