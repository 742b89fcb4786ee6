#!/usr/bin/env bash
# DuckDB 2.0.1: statistics over UNIX times lose digits, and a correlation is larger than 1.
#
# x = t/2 exactly, 100,000 rows in one second from t = 1.76e9 s, which doubles resolve to 2.4e-7 s: the straight line through the stored values is right to 1e-9.
# Seen: regr_slope 0.50068 for 0.5, corr 1.00000002, var_samp(t) 0.3 % too small.
# With t - 1.76e9 in the same query all are right to 1e-9. Of the same table pandas 3.1.1 and Arrow 26.0.1 have the variance right to 1e-14;
# Polars 2.1.0 is 1e-4 off. 111 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages duckdb==2.0.1 polars==2.1.0 pandas==3.1.1 pyarrow==26.0.1 numpy==2.4.6

python - <<'PYTHON'
import duckdb
import numpy as np
import pandas as pd
import polars as pl
import pyarrow as pa
import pyarrow.compute as pc

duckdb.sql("set threads to 1")
clock = 1.76e9 + np.arange(100_000) * 1e-5
table = pd.DataFrame({"t": clock, "x": 0.5 * (clock - 1.76e9)})
since = clock - 1.76e9
variance = since.var(ddof=1)


def statistics(time):
    query = f"select regr_slope(x, {time}), corr(x, {time}), var_samp({time}) from table_"
    return duckdb.sql(query).fetchall()[0]


table_ = table
slope, correlation, spread = statistics("t")
print(slope, correlation, spread / variance)
assert abs(slope - 0.50068) < 1e-4 and correlation > 1.0 + 1e-8
assert abs(spread / variance - 0.99729) < 1e-4
assert np.allclose(statistics("(t - 1.76e9)"), [0.5, 1.0, variance], rtol=1e-9, atol=0.0)
assert abs(table.t.var() / variance - 1.0) < 1e-9
assert abs(pc.variance(pa.array(clock), ddof=1).as_py() / variance - 1.0) < 1e-9
polars = pl.from_pandas(table)["t"].var() / variance
print("Polars", polars)
assert 1e-5 < abs(polars - 1.0) < 1e-3
PYTHON
