#!/usr/bin/env python3
"""Tries our files and derivatives with other programs: a table of docs/works-with.md.

    target/venv/bin/python scripts/works_with.py [--only PROGRAM …]

It runs by a Python that has our package. Packages come from PyPI, in their newest versions, into a
temporary folder; programs that are not on the path are left out and named. Ten minutes; with
`--only` the rows are printed instead.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import venv
from dataclasses import dataclass
from pathlib import Path

import littlewood

PAGE = Path(__file__).resolve().parents[1] / "docs" / "works-with.md"
JUMP = """
import jax, jax.numpy as jnp, littlewood as lw, littlewood.jax
jax.config.update("jax_enable_x64", True)
hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
jump = littlewood.jax.summary(["lift_off_time"], hoop, theta=2.5, theta_rate=3.0)
time = lambda mu_k: jump({"mu_k": mu_k})["lift_off_time"]
slope = float(jax.grad(time)(0.4))
"""
TABLE = """
import pandas
table = pandas.read_parquet("map.parquet")
right = int((table.lift_off_time > 1).sum())
"""
STORE = 'import xarray\nplane = xarray.open_zarr("map.zarr")\n'


@dataclass(frozen=True)
class Trial:
    """A program, what is run, and what must hold: `code` fails where it does not."""

    program: str
    what: str
    result: str
    code: str
    packages: str = ""
    """Of PyPI; none for a program on the path, which `code` is a command of."""


TRIALS = (
    Trial(
        "polars",
        "map.parquet, `lift_off_time > 1`",
        "the rows that pandas counts. NaN of a NumPy array is larger than any number: "
        "`nan_to_null=True`",
        TABLE
        + """
import polars
late = polars.col("lift_off_time") > 1
assert polars.scan_parquet("map.parquet").filter(late).collect().height == right
values = {"lift_off_time": table.lift_off_time.to_numpy()}
assert polars.DataFrame(values).filter(late).height > right
assert polars.DataFrame(values, nan_to_null=True).filter(late).height == right
""",
        "polars pandas pyarrow",
    ),
    Trial(
        "duckdb",
        "map.parquet, the same by SQL",
        "the rows that pandas counts",
        TABLE
        + """
import duckdb
query = "select count(*) from 'map.parquet' where lift_off_time > 1"
assert duckdb.sql(query).fetchall() == [(right,)]
""",
        "duckdb pandas pyarrow",
    ),
    Trial(
        "datafusion",
        "map.parquet, the same by SQL",
        "the rows that pandas counts",
        TABLE
        + """
import datafusion
context = datafusion.SessionContext()
context.register_parquet("map", "map.parquet")
query = "select count(*) as n from map where lift_off_time > 1"
assert context.sql(query).to_pydict()["n"] == [right]
""",
        "datafusion pandas pyarrow",
    ),
    Trial(
        "tensorstore",
        "every column of map.zarr",
        "the numbers that zarr reads",
        """
import numpy, tensorstore, zarr
store = zarr.open("map.zarr")
for name, column in store.arrays():
    where = {"driver": "file", "path": f"map.zarr/{name}"}
    read = tensorstore.open({"driver": "zarr3", "kvstore": where}).result().read().result()
    assert numpy.array_equal(read, column[:], equal_nan=column.dtype.kind == "f"), name
""",
        "tensorstore zarr",
    ),
    Trial(
        "xarray",
        "map.zarr to netCDF-4, by netcdf4 and h5netcdf, and to Zarr v2",
        "the same data set; for Zarr v2 after `drop_encoding()`",
        STORE
        + """
for engine in ("netcdf4", "h5netcdf"):
    plane.to_netcdf(f"{engine}.nc", engine=engine)
    assert xarray.open_dataset(f"{engine}.nc", engine=engine).identical(plane)
plane.drop_encoding().to_zarr("two.zarr", zarr_format=2)
assert xarray.open_zarr("two.zarr").equals(plane)
""",
        "xarray zarr netcdf4 h5netcdf h5py",
    ),
    Trial(
        "cf-xarray",
        "`plane.outcome.cf == 'landing'`",
        "codes by their names",
        STORE
        + """
import cf_xarray
assert (plane.outcome.cf == "landing").identical(plane.outcome == 0)
""",
        "cf-xarray xarray zarr",
    ),
    Trial(
        "pint-xarray",
        "`quantify()` of a motion",
        "angles are in rad, all else is dimensionless: multiply by the attribute `scale` yourself",
        """
import littlewood as lw, pint_xarray
motion = lw.case("figure-3").simulate().to_xarray().pint.quantify()
assert str(motion.theta.pint.units) == "radian"
assert str(motion.normal.pint.units) == "dimensionless"
assert motion.normal.attrs["scale"] == "m2 g"
""",
        "pint-xarray xarray numpy",
    ),
    Trial(
        "typst",
        "map.svg and map.pdf as images",
        "a page each; letters of the PDF stay text",
        """
import typst
open("a.typ", "w").write('#image("map.svg")\\n#pagebreak()\\n#image("map.pdf")')
assert len(typst.compile("a.typ")) > 10_000
""",
        "typst",
    ),
    Trial(
        "cairosvg",
        "map.svg to PNG",
        "a picture",
        """
import cairosvg
assert len(cairosvg.svg2png(url="map.svg", output_width=1200)) > 20_000
""",
        "cairosvg",
    ),
    Trial(
        "pymupdf",
        "text of map.pdf",
        "the key can be searched",
        """
import pymupdf
assert "rolls for ever" in pymupdf.open("map.pdf")[0].get_text()
""",
        "pymupdf",
    ),
    Trial(
        "equinox",
        "`filter_grad` of a lift-off",
        "right for arrays; Python's numbers are constants for it, and have the derivative None",
        JUMP
        + """
import equinox
loss = equinox.filter_jit(equinox.filter_grad(lambda q: jump(q)["lift_off_time"]))
assert abs(loss({"mu_k": jnp.array(0.4)})["mu_k"] - slope) < 1e-12
assert loss({"mu_k": 0.4})["mu_k"] is None
""",
        "equinox jax xarray",
    ),
    Trial(
        "optimistix",
        "μk of a given lift-off by Newton, Levenberg–Marquardt and BFGS",
        "all find it",
        JUMP
        + """
import optimistix
miss = lambda mu_k, _: time(mu_k) - time(0.4)
for found in (
    optimistix.root_find(miss, optimistix.Newton(1e-10, 1e-10), jnp.array(0.35)),
    optimistix.least_squares(miss, optimistix.LevenbergMarquardt(1e-10, 1e-10), jnp.array(0.3)),
    optimistix.minimise(
        lambda mu_k, _: miss(mu_k, _) ** 2, optimistix.BFGS(1e-9, 1e-12), jnp.array(0.35)
    ),
):
    assert abs(found.value - 0.4) < 1e-8
""",
        "optimistix jax xarray",
    ),
    Trial(
        "numpyro",
        "NUTS for μk from a lift-off, two chains at once",
        "samples within the prior",
        JUMP
        + """
import numpyro, numpyro.distributions as draw
from numpyro.infer import MCMC, NUTS
seen = float(time(0.4))
def model():
    mu_k = numpyro.sample("mu_k", draw.Uniform(0.2, 0.5))
    numpyro.sample("seen", draw.Normal(time(mu_k), 0.01), obs=seen)
chains = MCMC(
    NUTS(model),
    num_warmup=50,
    num_samples=50,
    num_chains=2,
    chain_method="vectorized",
    progress_bar=False,
)
chains.run(jax.random.PRNGKey(0))
assert 0.2 < chains.get_samples()["mu_k"].mean() < 0.5
""",
        "numpyro jax xarray",
    ),
    Trial(
        "jax",
        "`jacfwd`, `vmap`, `scan`, `checkpoint`; `hessian`; `jax.export`",
        "derivatives of first order are right; a second one raises TypeError; a function "
        "that calls us cannot be exported",
        JUMP
        + """
assert abs(jax.jacfwd(time)(0.4) - slope) < 1e-12
assert abs(jax.vmap(jax.grad(time))(jnp.array([0.3, 0.4]))[1] - slope) < 1e-12
assert abs(jax.grad(jax.checkpoint(time))(0.4) - slope) < 1e-12
total = lambda m: jax.lax.scan(lambda sum, _: (sum + time(m), None), 0.0, jnp.arange(2))[0]
assert abs(jax.grad(total)(0.4) - 2.0 * slope) < 1e-12
try:
    jax.hessian(time)(0.4)
    raise AssertionError
except TypeError as error:
    assert "first derivatives only" in str(error)
try:
    jax.export.export(jax.jit(time))(jax.ShapeDtypeStruct((), jnp.float64))
    raise AssertionError
except NotImplementedError:
    pass
""",
        "jax xarray",
    ),
    Trial(
        "sleap-io",
        "tables of `save_csv` in its five layouts as tracks",
        "refused by name, with the table to write; its layout of DeepLabCut [has no "
        "likelihoods](../findings/README.md): take the layout `sleap`",
        """
import numpy, littlewood as lw, sleap_io
skeleton = sleap_io.Skeleton(["centre", "marker"])
film = sleap_io.Video(filename="film.mp4", open_backend=False)
one = sleap_io.PredictedInstance.from_numpy(
    numpy.array([[1.0, 2.0], [3.0, 4.0]]), point_scores=numpy.ones(2), score=1.0, skeleton=skeleton)
labels = sleap_io.Labels([sleap_io.LabeledFrame(video=film, frame_idx=0, instances=[one])])
for layout in ("sleap", "dlc", "points", "instances", "frames"):
    sleap_io.save_csv(labels, "track.csv", format=layout)
    try:
        lw.Track.from_csv("track.csv")
        raise AssertionError(layout)
    except ValueError as error:
        assert "SLEAP" in str(error) or "DeepLabCut" in str(error), error
""",
        "sleap-io pandas",
    ),
    Trial(
        "gs",
        "map.pdf to PNG",
        "without a word. Its PDF/A has no place for the letters of our `Subject`: it says"
        " so and writes plain PDF",
        "gs -q -dNOPAUSE -dBATCH -sDEVICE=png16m -r150 -sOutputFile=gs.png map.pdf",
    ),
    Trial(
        "rsvg-convert",
        "map.svg to PNG",
        "a picture",
        "rsvg-convert map.svg -o rsvg.png",
    ),
    Trial(
        "lualatex",
        "map.pdf by `includegraphics`",
        "letters embedded, text can be searched",
        "lualatex -interaction=batchmode "
        "'\\documentclass{article}\\usepackage{graphicx}\\begin{document}\\includegraphics[width=8cm]{map.pdf}\\end{document}'",
    ),
)


def outputs(folder):
    """What the trials read: one map as table, store and pictures."""
    plane = ["--x", "theta=-pi:pi:200", "--y", "theta_rate=-4:4:150"]
    files = [f"map.{kind}" for kind in ("parquet", "zarr", "svg", "pdf")]
    command = [sys.executable, "-m", "littlewood", "map", "figure-3", *plane]
    for file in files:
        command += ["--out", file]
    subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    (folder / "own").mkdir()
    (folder / "own" / "littlewood").symlink_to(Path(littlewood.__file__).parent)


def attempt(trial, folder):
    """The version, and why a trial failed, or None."""
    if not trial.packages:
        if shutil.which(trial.program) is None:
            return "not on the path", None
        said = subprocess.run([trial.program, "--version"], capture_output=True, text=True).stdout
        done = subprocess.run(trial.code, shell=True, cwd=folder, capture_output=True, text=True)
        version = re.search(r"\d+(\.\d+)+", said)
    else:
        python = folder / "venv" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
        if not python.exists():
            venv.create(folder / "venv", with_pip=True)
        quiet = ["--quiet", "--disable-pip-version-check"]
        pip = [python, "-m", "pip", "install", *quiet]
        subprocess.run([*pip, *trial.packages.split()], check=True)
        done = subprocess.run(
            [python, "-W", "ignore", "-c", trial.code],
            cwd=folder,
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONPATH": str(folder / "own")},
        )
        ask = f"from importlib.metadata import version; print(version({trial.program!r}))"
        said = subprocess.run([python, "-c", ask], capture_output=True, text=True).stdout
        version = re.search(r"\S+", said)
    why = None
    if done.returncode:
        lines = (done.stderr or done.stdout).strip().splitlines()
        # What JAX adds stands below the error.
        why = next((line for line in reversed(lines) if "Error" in line), "no message")
    return version.group() if version else "?", why


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--only", nargs="+", choices=[trial.program for trial in TRIALS])
    only = arguments.parse_args().only
    lines, failed = ["| program | version | run | result |", "|---|---|---|---|"], 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        outputs(folder)
        for trial in TRIALS:
            if only and trial.program not in only:
                continue
            print(f"trying {trial.program}", file=sys.stderr)
            version, why = attempt(trial, folder)
            failed += why is not None
            result = f"**not any more**: {why}" if why else trial.result
            lines.append(f"| {trial.program} | {version} | {trial.what} | {result} |")
    table = "\n".join(lines) + "\n"
    if only:
        print(table)
    else:
        text = PAGE.read_text(encoding="utf-8")
        begin, end = "<!-- trials -->\n", "<!-- /trials -->"
        before, after = text.split(begin)[0], text.split(end)[1]
        PAGE.write_text(before + begin + table + end + after, encoding="utf-8")
    raise SystemExit(1 if failed else 0)


if __name__ == "__main__":
    main()
