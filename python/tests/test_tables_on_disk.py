"""What other programs read.

Tables in Parquet, stores and data sets as netCDF, and colours of films.
"""

import json
import math
import os
import subprocess

import cv2
import duckdb
import imageio_ffmpeg
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.dataset
import pyarrow.parquet as pq
import pytest
import xarray
from PIL import Image

import littlewood as lw

AXES = ("--axis", "theta=-3:3:23", "--axis", "theta_rate=-4:4:31")


@pytest.fixture
def path(tmp_path):
    return tmp_path / "grid.parquet"


@pytest.fixture
def table(command, path):
    done = command(
        "sweep", "figure-3", *AXES, "--until", "50", "--chunk", "100", "--out", str(path)
    )
    assert done.returncode == 0, done.stderr
    return pq.ParquetFile(path)


def test_columns_have_types_and_attributes(table):
    schema = table.schema_arrow
    assert schema.field("theta").type == pa.float64()
    assert schema.field("outcome_code").type == pa.uint8()
    assert schema.field("sequence_code").type == pa.uint64()
    assert schema.field("transitions").type == pa.uint32()
    assert schema.field("painleve").type == pa.bool_()
    words = pa.dictionary(pa.int32(), pa.string())
    assert (schema.field("outcome").type, schema.field("sequence").type) == (words, words)
    # Real numbers are null where an event does not happen; nothing else ever is.
    assert all(field.nullable == (field.type == pa.float64()) for field in schema)
    for field in schema:
        assert field.metadata[b"long_name"], field.name
    assert (schema.field("theta").metadata[b"units"], schema.field("theta").metadata[b"scale"]) == (
        b"rad",
        b"1",
    )
    assert schema.field("lift_off_time").metadata[b"scale"] == b"sqrt(R/g)"
    codes = schema.field("outcome_code").metadata
    assert dict(
        zip(
            json.loads(codes[b"flag_values"]), codes[b"flag_meanings"].decode().split(), strict=True
        )
    ) == {code: name for code, name in lw.tables.OUTCOMES.items()}


def test_rows_are_the_motions(table, hoop):
    read = table.read()
    assert table.num_row_groups > 1 and read.num_rows == 23 * 31
    theta, rate = read["theta"].to_numpy(), read["theta_rate"].to_numpy()
    ours = lw.simulate_many(hoop, theta=theta, theta_rate=rate, until=50.0)
    for name in ("lift_off_time", "end_x", "energy"):
        values = np.asarray(ours[name])
        assert read[name].null_count == np.isnan(values).sum(), name
        assert read[name].to_numpy().tobytes() == values.tobytes(), name
    assert read["transitions"].to_numpy().tobytes() == np.asarray(ours["transitions"]).tobytes()
    words = read["outcome"].to_pylist()
    assert words == [lw.tables.OUTCOMES[int(code)] for code in np.asarray(ours["outcome"])]
    frame = read.to_pandas()
    assert frame["outcome"].dtype.name == "category"
    assert json.loads(table.metadata.metadata[b"littlewood_run"])["fixed"]["mu_k"] == 0.4


def test_a_list_that_pandas_wrote_is_followed(command, tmp_path):
    starts, out = tmp_path / "starts.csv", tmp_path / "motions.parquet"
    rows = {
        "theta": [math.pi / 2, 0.0],
        "theta_rate": [2, 1],
        "x": [0.5, 0.25],
        "mu_k": [0.4, 0.25],
    }
    pd.DataFrame(rows).to_csv(starts, index=False)
    done = command("sweep", "figure-3", "--starts", str(starts), "--out", str(out))
    assert done.returncode == 0, done.stderr
    read = pq.read_table(out)
    assert read["sequence"].to_pylist()[0] == "-R+F"
    assert read["theta"].to_pylist() == rows["theta"]
    assert read["x"].to_pylist() == rows["x"]


def test_engines_agree_about_what_does_not_happen(table, path, hoop):
    read = table.read(["theta", "theta_rate"])
    theta, rate = read["theta"].to_numpy(), read["theta_rate"].to_numpy()
    time = np.asarray(
        lw.simulate_many(hoop, theta=theta, theta_rate=rate, until=50.0).lift_off_time
    )
    late, happens = int((time > 1.0).sum()), int(np.isfinite(time).sum())
    assert 0 < late < happens < time.size
    counted = {
        "polars": pl.scan_parquet(path)
        .filter(pl.col("lift_off_time") > 1.0)
        .select(pl.len())
        .collect()
        .item(),
        "duckdb": duckdb.sql(f"select count(*) from '{path}' where lift_off_time > 1.0").fetchall()[
            0
        ][0],
        "pyarrow": pq.read_table(path, filters=[("lift_off_time", ">", 1.0)]).num_rows,
        "pandas": int((pd.read_parquet(path).lift_off_time > 1.0).sum()),
    }
    assert counted == dict.fromkeys(counted, late)
    ((most, number),) = duckdb.sql(
        f"select max(lift_off_time), count(lift_off_time) from '{path}'"
    ).fetchall()
    assert (most, number) == (np.nanmax(time), happens)
    column = pl.read_parquet(path)["lift_off_time"]
    assert (column.max(), column.null_count()) == (np.nanmax(time), time.size - happens)


def test_minima_and_maxima_let_readers_skip_chunks(table, path):
    names = table.schema_arrow.names
    for name in ("theta", "lift_off_time", "end_x", "energy"):
        for group in range(table.num_row_groups):
            said = table.metadata.row_group(group).column(names.index(name)).statistics
            values = table.read_row_group(group, [name])[name]
            present = values.drop_null().to_numpy()
            assert said.null_count == values.null_count
            assert said.has_min_max == (present.size > 0)
            if present.size > 0:
                assert (said.min, said.max) == (present.min(), present.max())
    (fragment,) = pyarrow.dataset.dataset(path).get_fragments()
    assert len(fragment.row_groups) == table.num_row_groups
    few = fragment.subset(pc.field("theta") < -2.9).row_groups
    assert len(few) == 1 < table.num_row_groups


def _again(dataset, path):
    """A data set from netCDF, with what it was saved from: names, types, values, attributes."""
    dataset.to_netcdf(path, engine="h5netcdf")
    again = xarray.load_dataset(path, engine="h5netcdf")
    xarray.testing.assert_equal(again, dataset)
    assert set(again.attrs) == set(dataset.attrs)
    for name, variable in dataset.variables.items():
        assert set(again[name].attrs) == set(variable.attrs), name
        values = again[name].attrs.get("flag_values")
        # CF: of the type of the variable.
        assert values is None or values.dtype == again[name].dtype, name
    return again


def test_a_store_is_saved_as_netcdf(command, tmp_path):
    store = tmp_path / "plane.zarr"
    done = command("sweep", "figure-3", *AXES, "--until", "50", "--out", str(store))
    assert done.returncode == 0, done.stderr
    plane = xarray.open_zarr(store, mask_and_scale=False).load()
    for variable in plane.variables.values():
        # JSON has no types of numbers.
        if "flag_values" in variable.attrs:
            variable.attrs["flag_values"] = np.array(variable.attrs["flag_values"], variable.dtype)
    again = _again(plane, tmp_path / "plane.nc")
    assert json.loads(again.attrs["run"])["fixed"]["mu_k"] == 0.4
    assert json.loads(again.sequence.attrs["legend"])["7"] == "F: flight"


def test_data_sets_are_saved_as_netcdf(hoop, tmp_path):
    motion = hoop.simulate(theta=math.pi / 2, theta_rate=2.0)
    plane = lw.outcome_map(hoop, theta=[0.0, 1.0], theta_rate=[1.0, 2.0, 3.0], until=20.0)
    assert json.loads(plane.sequence.attrs["legend"])["7"] == "F: flight"
    bouncy = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=0.5)
    sets = {
        "plane": plane,
        "hops": lw.simulate_many(bouncy, theta=2.5, theta_rate=[0.1, 3.0], until=20.0),
        "motion": motion.to_xarray(count=11),
        "nothing": hoop.simulate(theta=1.0, theta_rate=0.0, max_transitions=0).to_xarray(count=3),
        "bounces": bouncy.simulate(theta=2.5, theta_rate=3.0, until=20.0).to_xarray(count=11),
        "events": motion.derivatives(),
        "states": motion.derivatives_at([0.1, 0.2]),
    }
    for name, dataset in sets.items():
        _again(dataset, tmp_path / f"{name}.nc")


def _colours_by_bt_709(planes, height, width):
    """What a screen shows of the planes of a frame, in the words of BT.709-6, items 3.3 to 3.5."""
    size = height * width
    y = planes[:size].reshape(height, width)
    blue, red = (
        planes[size + i * size // 4 :][: size // 4]
        .reshape(height // 2, width // 2)
        .repeat(2, 0)
        .repeat(2, 1)
        for i in range(2)
    )
    y, blue, red = (y - 16.0) / 219.0, (blue - 128.0) / 224.0, (red - 128.0) / 224.0
    r, b = y + 1.5748 * red, y + 1.8556 * blue
    return 255.0 * np.stack([r, (y - 0.2126 * r - 0.0722 * b) / 0.7152, b], axis=-1)


@pytest.mark.parametrize("ending", ["mp4", "webm"])
@pytest.mark.parametrize("size", [(320, 180), (1280, 720)])
def test_films_have_the_colours_of_the_drawing(ending, size, command, tmp_path, monkeypatch):
    programs = tmp_path / "bin"
    programs.mkdir()
    ffmpeg = programs / "ffmpeg"
    ffmpeg.symlink_to(imageio_ffmpeg.get_ffmpeg_exe())
    monkeypatch.setenv("PATH", f"{programs}{os.pathsep}{os.environ['PATH']}")
    width, height = size
    for name in ("film.gif", f"film.{ending}"):
        film = ["--size", f"{width}x{height}", "--fps", "2", "--until", "0.5"]
        done = command("animate", "figure-3", *film, "--out", str(tmp_path / name))
        assert done.returncode == 0, done.stderr
    with Image.open(tmp_path / "film.gif") as gif:
        drawn = np.asarray(gif.convert("RGB"), dtype=float)
    path = str(tmp_path / f"film.{ending}")
    first = [ffmpeg, "-v", "error", "-i", path, "-frames:v", "1", "-f", "rawvideo"]
    planes = subprocess.run([*first, "-pix_fmt", "yuv420p", "-"], capture_output=True, check=True)
    seen = {
        # A player that takes HD as BT.709, and one that goes by what the file says.
        "BT.709": _colours_by_bt_709(np.frombuffer(planes.stdout, np.uint8), height, width),
        "OpenCV": cv2.VideoCapture(path).read()[1][:, :, ::-1].astype(float),
    }
    # Away from edges, which the coding of colours at half the resolution blurs.
    near = np.ones((9, 9))
    flat = (cv2.dilate(drawn, near) == cv2.erode(drawn, near)).all(axis=-1)
    colours = np.unique(drawn[flat], axis=0)
    assert len(colours) > 1
    for reader, frame in seen.items():
        for colour in colours:
            found = frame[flat & (drawn == colour).all(axis=-1)]
            assert np.abs(np.median(found, axis=0) - colour).max() <= 4.0, (reader, colour)
