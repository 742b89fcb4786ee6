"""The how-tos: their code runs as it stands, block after block."""

import re
import subprocess
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray

from littlewood.lab import widget

PYTHON = Path(__file__).parents[1]
PAGES = [
    PYTHON / "README.md",
    *(
        PYTHON / "docs" / name
        for name in (
            "own-hoop.md",
            "jumps.md",
            "landing.md",
            "fit.md",
            "video.md",
            "lab.md",
            "score.md",
        )
    ),
    PYTHON.parent / "docs" / "start.md",
    PYTHON.parent / "docs" / "howto" / "experiments.md",
    PYTHON.parent / "docs" / "studies" / "gradients-through-contact.md",
]


@pytest.fixture(autouse=True)
def close_figures():
    """A page leaves its figures open for its reader; the next test counts the open ones."""
    yield
    plt.close("all")


@pytest.mark.thorough
@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_code_of_a_page_runs(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    if not widget._MODULE.exists():
        # A build without the page: what the widget is in the browser is tested in web/.
        monkeypatch.setattr(widget, "_MODULE", tmp_path / "laboratory.js")
        (tmp_path / "laboratory.js").write_text("export default { render() {} };", encoding="utf-8")
    blocks = re.findall(
        r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL
    )
    assert blocks
    names = {"__name__": page.stem}
    for block in blocks:
        exec(compile(block, str(page), "exec"), names)


def test_the_page_on_sweeps_reads_a_store_of_the_program(binary, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (PYTHON.parent / "docs" / "sweep.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    axes = ["--x", "theta=-pi:pi:9", "--y", "theta_rate=-4:4:7"]
    subprocess.run(
        [binary, "map", "figure-3", *axes, "--until", "5", "--out", "plane.zarr"], check=True
    )
    names = {}
    for block in blocks:
        exec(compile(block, "sweep.md", "exec"), names)
    assert names["plane"].outcome.shape == (9, 7)
    assert xarray.load_dataset("plane.nc").outcome.attrs["flag_values"].dtype == np.uint8


def test_links_lead_somewhere():
    for page in [*PAGES, PYTHON / "docs" / "cluster.md"]:
        for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"


@pytest.mark.thorough
def test_the_cluster_page_runs_on_a_cluster_of_this_machine(tmp_path, monkeypatch):
    from distributed import Client, LocalCluster

    monkeypatch.chdir(tmp_path)
    text = (PYTHON / "docs" / "cluster.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"^```python\n(# The sweep.*?)^```", text, re.MULTILINE | re.DOTALL)
    with (
        LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address="127.0.0.1:0") as cluster,
        Client(cluster) as client,
    ):
        names = {"client": client}
        exec(compile(block.replace("2001", "41"), "cluster.md", "exec"), names)
        assert np.isfinite(names["stored"].end_time).any()
