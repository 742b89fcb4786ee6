"""Films: a hoop and its marker found in the pictures of a film, films of simulated motions, both in one film.

:func:`littlewood.track_video` makes a track of a film, :func:`littlewood.fit` finds friction, inertia and restitution
by it, and :func:`overlay_video` draws the fitted motion over the film. :func:`synthetic_film` makes a film of a motion
whose coefficients are known. All of it needs OpenCV, the extra ``video``.
"""

from .camera import Camera
from .errors import (
    NoHoopError,
    TooFewPicturesError,
    UnreadableVideoError,
    UnwritableVideoError,
    VideoError,
    VideoFileError,
)
from .files import codecs, pictures, rate_of
from .finder import Circle, Finder, Marker
from .overlay import draw_motion, overlay_video
from .plane import Plane
from .synthetic import Look, synthetic_film, synthetic_pictures
from .tracking import finder_of, track_video

__all__ = [
    "Camera",
    "Circle",
    "Finder",
    "Look",
    "Marker",
    "NoHoopError",
    "Plane",
    "TooFewPicturesError",
    "UnreadableVideoError",
    "UnwritableVideoError",
    "VideoError",
    "VideoFileError",
    "codecs",
    "draw_motion",
    "finder_of",
    "overlay_video",
    "pictures",
    "rate_of",
    "synthetic_film",
    "synthetic_pictures",
    "track_video",
]
