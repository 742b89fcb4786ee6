"""Videos of hoops, found and made.

A hoop and its marker found in the frames of a video, videos of simulated motions, both in one.

:func:`littlewood.track_video` makes a track of a video, :func:`littlewood.fit` finds friction,
inertia and restitution by it, and :func:`overlay_video` draws the fitted motion over the video.
:func:`synthetic_video` makes a video of a motion whose coefficients are known. All of it needs
OpenCV, the extra ``video``.
"""

from .camera import Camera
from .clock import Clock, clock_of, rate_of
from .errors import (
    NoHoopError,
    NoMarkerError,
    NoPictureError,
    TooFewFramesError,
    UnreadableVideoError,
    UnwritableVideoError,
    VideoError,
    VideoFileError,
    VideoWarning,
)
from .files import codecs, frames
from .finder import Circle, Finder, Marker
from .hoop_as_ruler import find_plane
from .overlay import draw_motion, overlay_picture, overlay_video
from .plane import Plane
from .sheet import marker_sheet
from .synthetic import Look, synthetic_frames, synthetic_video
from .tracking import finder_of, track_video

__all__ = [
    "Camera",
    "Circle",
    "Clock",
    "Finder",
    "Look",
    "Marker",
    "NoHoopError",
    "NoMarkerError",
    "NoPictureError",
    "Plane",
    "TooFewFramesError",
    "UnreadableVideoError",
    "UnwritableVideoError",
    "VideoError",
    "VideoFileError",
    "VideoWarning",
    "clock_of",
    "codecs",
    "draw_motion",
    "find_plane",
    "finder_of",
    "frames",
    "marker_sheet",
    "overlay_picture",
    "overlay_video",
    "rate_of",
    "synthetic_frames",
    "synthetic_video",
    "track_video",
]
