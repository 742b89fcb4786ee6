#!/usr/bin/env bash
# sleap-io 0.9.5: a table of predictions written in DeepLabCut's layout has no likelihoods.
#
# Two points in three frames, with scores 0.9 and 0.8 as a network gives them.
# `save_csv(…, format="sleap")` has the scores; `format="dlc"` has the columns `likelihood`, and leaves every cell of them empty,
# so that whoever drops points below a likelihood, as DeepLabCut's tools do, keeps none of them.
# 170 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages sleap-io==0.9.5 pandas==3.1.1

cd "$folder" || exit
python - <<'PYTHON'
import csv

import numpy as np
import sleap_io

skeleton = sleap_io.Skeleton(["centre", "marker"])
film = sleap_io.Video(filename="film.mp4", open_backend=False)
frames = [
    sleap_io.LabeledFrame(
        video=film,
        frame_idx=i,
        instances=[
            sleap_io.PredictedInstance.from_numpy(
                np.array([[10.0 + i, 20.0], [15.0 + i, 25.0]]),
                point_scores=np.array([0.9, 0.8]),
                score=0.9,
                skeleton=skeleton,
            )
        ],
    )
    for i in range(3)
]
labels = sleap_io.Labels(frames)
for layout in ("sleap", "dlc"):
    sleap_io.save_csv(labels, f"{layout}.csv", format=layout)

own = list(csv.DictReader(open("sleap.csv")))
assert [(row["centre.score"], row["marker.score"]) for row in own] == [("0.9", "0.8")] * 3, own
rows = list(csv.reader(open("dlc.csv")))
columns = [i for i, name in enumerate(rows[2]) if name == "likelihood"]
cells = [row[i] for row in rows[3:] for i in columns]
print(rows[2], cells)
assert len(cells) == 6 and not any(cells), cells
PYTHON
