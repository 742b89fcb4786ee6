"""Tables of the command line in Parquet, as Arrow and pandas read them."""

import json
import math

import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

import littlewood as lw

AXES = ("--axis", "theta=-3:3:23", "--axis", "theta_rate=-4:4:31")


@pytest.fixture
def table(command, tmp_path):
    path = tmp_path / "grid.parquet"
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
    assert not any(field.nullable for field in schema)
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
        assert read[name].to_numpy().tobytes() == np.asarray(ours[name]).tobytes(), name
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
