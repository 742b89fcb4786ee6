#!/usr/bin/env bash
# imageio 2.38.1: one film with a variable frame rate has 17, 31 or 36 frames, and frames a second that fit none of them.
#
# PyAV 18.1.0 writes 17 frames in 1.03 s as H.264 in MP4: 30 a second, with gaps of 0.1 to 0.27 s, as a telephone does when light fails.
# Read back, PyAV's stamps are those that were written. With imageio:
#
#   plugin `pyav`     17 frames, each once;    the metadata say 30 frames a second, which makes 0.57 s of 1.03
#   plugin `FFMPEG`   31 frames, some twice;   the metadata say 16.45 a second, which makes 1.88 s
#   the same film with B-frames, plugin `FFMPEG`: 36 frames
#
# Neither plugin tells the times of frames that it yields, so that number over rate is what a user has. 80 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages av==18.1.0 imageio==2.38.1 imageio-ffmpeg==0.8.1 numpy==2.4.6

cd "$folder" || exit
python - <<'PYTHON'
from fractions import Fraction

import av
import imageio.v3 as imageio
import numpy as np

MILLISECONDS = [0, 33, 67, 100, 133, 233, 267, 300, 500, 533, 567, 600, 633, 900, 933, 967, 1000]


def write(name, b_frames):
    with av.open(name, "w") as film:
        stream = film.add_stream("libx264", rate=30, options={"bf": str(b_frames)})
        stream.width = stream.height = 64
        stream.pix_fmt = "yuv420p"
        stream.time_base = stream.codec_context.time_base = Fraction(1, 1000)
        for i, stamp in enumerate(MILLISECONDS):
            frame = av.VideoFrame.from_ndarray(np.full((64, 64, 3), 10 * i, np.uint8), "rgb24")
            frame.pts, frame.time_base = stamp, Fraction(1, 1000)
            film.mux(stream.encode(frame))
        film.mux(stream.encode())


for b_frames, counted in ((0, 31), (3, 36)):
    name = f"{b_frames}.mp4"
    write(name, b_frames)
    with av.open(name) as film:
        assert [round(1000 * frame.time) for frame in film.decode(video=0)] == MILLISECONDS
    for plugin, count, rate in (("pyav", 17, 30.0), ("FFMPEG", counted, 16.45)):
        frames = imageio.imread(name, plugin=plugin)
        said = imageio.immeta(name, plugin=plugin)
        print(b_frames, plugin, len(frames), said["fps"], said["duration"])
        assert (len(frames), round(said["fps"], 2)) == (count, rate)
        assert abs(said["duration"] - 1.03) < 0.01
PYTHON
