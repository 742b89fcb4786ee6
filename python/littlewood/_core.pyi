from collections.abc import Callable, Sequence
from typing import Any, final

import numpy as np
import numpy.typing as npt

# Numbers in the order of START and SI_START; those of a state come in that of STATE.
_Numbers = Sequence[float]
# Numbers in the order of HOOP and SI_HOOP, of which some may be absent.
_HoopNumbers = Sequence[float | None]
# The numbers of a hoop and the name of its law of restitution.
_Hoop = tuple[_HoopNumbers, str | None]
# θ′, η′ and the rate of the gap.
_Velocities = tuple[float, float, float]
# Case, velocities before and after, impulse, works, energy lost.
_Impact = tuple[str, _Velocities, _Velocities, tuple[float, float], float, float, float]
_Scales = tuple[float, float, float]
_Reals = npt.NDArray[np.float64]

__all__ = [
    "AXES",
    "CAUSES",
    "CLASSES",
    "DIRECTIONS",
    "HOOP",
    "IMPACT_CASES",
    "MAX_SLIDES",
    "MAX_TRANSITIONS",
    "MODES",
    "MOST_COUNT",
    "MOST_POINTS",
    "MOST_THREADS",
    "OUTCOMES",
    "OUTSIDE",
    "PHASES",
    "PROOF",
    "PROOFS",
    "REGIONS",
    "RESTITUTION_LAWS",
    "ROLLING_TYPES",
    "SAMPLE_COUNTS",
    "SEQUENCE_CAPACITY",
    "SEQUENCE_ENCODING",
    "SEQUENCE_VERSION",
    "SI_HOOP",
    "SI_START",
    "STANDARD_GRAVITY",
    "START",
    "STATE",
    "ParameterError",
    "PhasePlane",
    "Trajectory",
    "__version__",
    "alpha",
    "bouncing_orbit",
    "cases",
    "check_hoop",
    "check_proof",
    "check_until",
    "classes",
    "classify",
    "curves",
    "dashes",
    "derived_units",
    "digest_line",
    "edges",
    "gliding_path",
    "gliding_time_to_plane",
    "hoop_from_si",
    "in_rolling_region",
    "name_of_case",
    "problem_of_link",
    "quantities",
    "read_link",
    "rolling_angle",
    "rolling_energy",
    "rolling_friction",
    "rolling_half_sine",
    "rolling_normal",
    "rolling_time_to_plane",
    "rolling_type",
    "run_program",
    "sample_columns",
    "sample_in_si",
    "sequence_names",
    "simulate",
    "slip_angle",
    "slip_time_from_top",
    "stable_manifold_rate",
    "start_from_si",
    "summaries",
    "summary_columns",
    "swatches",
    "unloading_time_from_top",
    "unstable_manifold_rate",
    "write_link",
]
__version__: str
AXES: list[str]
CAUSES: list[tuple[int, str, str]]
CLASSES: list[tuple[int, str, str]]
DIRECTIONS: list[tuple[int, str]]
HOOP: list[str]
IMPACT_CASES: list[tuple[int, str, str]]
MAX_SLIDES: int
MAX_TRANSITIONS: int
PROOF: str
PROOFS: list[str]
MOST_THREADS: int
MODES: list[tuple[int, str]]
MOST_POINTS: int
MOST_COUNT: int
OUTCOMES: list[tuple[int, str, str, bool]]
OUTSIDE: int
PHASES: list[tuple[int, str, str]]
REGIONS: list[tuple[int, str]]
RESTITUTION_LAWS: list[tuple[int, str, str]]
ROLLING_TYPES: list[tuple[int, str]]
SAMPLE_COUNTS: tuple[int, int]
SEQUENCE_CAPACITY: int
SEQUENCE_ENCODING: str
SEQUENCE_VERSION: int
SI_HOOP: list[str]
SI_START: list[str]
STANDARD_GRAVITY: float
START: list[str]
STATE: list[str]

class ParameterError(ValueError):
    quantity: str
    hint: str
    index: int | None

@final
class Trajectory:
    def phases(self) -> list[tuple[str, int, list[float], list[float] | None, float, float, bool, int | None]]: ...
    def transitions(
        self,
    ) -> list[tuple[list[float], list[float], _Impact | None, str | None, str | None, int, str]]: ...
    def outcome(self) -> tuple[str, list[float], dict[str, Any], str]: ...
    def text(self) -> str: ...
    def blocks(self) -> list[tuple[str, list[str], list[tuple[str | None, list[str]]], list[int]]]: ...
    def end_time(self) -> float: ...
    def shown_until(self) -> float: ...
    def energy_lost(self) -> float: ...
    def impact_energy_lost(self) -> float: ...
    def sequence(self) -> str: ...
    def at(self, times: _Reals, is_before: bool) -> dict[str, npt.NDArray[Any]]: ...
    def sample_evenly(self, count: int, until: float) -> dict[str, npt.NDArray[Any]]: ...

@final
class PhasePlane:
    def __new__(cls, given: _Hoop) -> PhasePlane: ...
    def normal(self, theta: _Reals, theta_rate: _Reals) -> _Reals: ...
    def friction(self, theta: _Reals, theta_rate: _Reals) -> _Reals: ...
    def energy(self, theta: _Reals, theta_rate: _Reals) -> _Reals: ...
    def in_contact_region(self, theta: _Reals, theta_rate: _Reals) -> npt.NDArray[np.bool_]: ...
    def in_rolling_region(self, theta: _Reals, theta_rate: _Reals) -> npt.NDArray[np.bool_]: ...
    def normal_force_rate(self, theta: _Reals) -> _Reals: ...
    def slip_rate(self, theta: _Reals, direction: float) -> _Reals: ...
    def lift_off_rate(self, theta: _Reals) -> _Reals: ...
    def separatrix_rate(self, theta: _Reals) -> _Reals: ...
    def level_rate(self, theta: _Reals, energy: _Reals) -> _Reals: ...
    def equilibria(self) -> list[tuple[float, str, float]]: ...
    def regions(self, theta: _Reals, theta_rate: _Reals, slip: _Reals) -> npt.NDArray[np.uint8]: ...

def bouncing_orbit(given: _Hoop, angle: float) -> tuple[float, float, float, float, float, list[float]] | None: ...
def check_hoop(given: _Hoop) -> tuple[float, float, float, str | None]: ...
def check_until(until: float) -> None: ...
def check_proof(proof: str) -> None: ...
def hoop_from_si(
    numbers: _HoopNumbers, law_name: str | None
) -> tuple[list[float | None], tuple[float, float, float, float]]: ...
def start_from_si(scales: _Scales, numbers: _Numbers, until_s: float | None) -> tuple[list[float], float | None]: ...
def sample_in_si(scales: _Scales, column: str, values: _Reals) -> _Reals: ...
def derived_units(scales: _Scales) -> tuple[float, float, float, float, float]: ...
def simulate(
    given: _Hoop, start_numbers: _Numbers, until: float | None, max_transitions: int, max_slides: int, proof: str
) -> Trajectory: ...
def classify(given: _Hoop, start_numbers: _Numbers) -> dict[str, Any]: ...
def summaries(
    columns: list[_Reals | None],
    law_name: str | None,
    count: int,
    until: float | None,
    max_transitions: int,
    max_slides: int,
    proof: str,
    starts: int,
    threads: int,
    progress: Callable[[int], object] | None,
) -> dict[str, npt.NDArray[Any]]: ...
def classes(
    outcome: npt.NDArray[np.uint8], sequence: npt.NDArray[np.uint64], lift_off_time: _Reals
) -> npt.NDArray[np.uint8]: ...
def read_link(link: str) -> tuple[tuple[str, str, str] | None, bool, float | None]: ...
def problem_of_link(
    link: str,
) -> tuple[list[float | None], str | None, tuple[float, float, float, float] | None, list[float], float | None]: ...
def write_link(given: _Hoop, start_numbers: _Numbers, until: float | None, at: float | None, shown: str) -> str: ...
def quantities() -> list[dict[str, Any]]: ...
def sample_columns() -> list[dict[str, Any]]: ...
def summary_columns() -> list[dict[str, Any]]: ...
def swatches(dark: bool) -> list[tuple[str, str, str]]: ...
def dashes() -> list[tuple[str, str, list[float]]]: ...
def curves() -> list[tuple[str, str | None, str, float]]: ...
def digest_line(block: int) -> str: ...
def run_program(arguments: Sequence[str]) -> int: ...
def cases() -> list[tuple[str, str, str, list[float | None], str | None, list[float]]]: ...
def name_of_case(name: str) -> str | None: ...
def edges() -> list[tuple[str, str | None, str, str, str, str | None, str]]: ...
def sequence_names(bits: npt.NDArray[np.uint64]) -> list[str]: ...
def rolling_energy(theta: _Reals, theta_rate: _Reals) -> _Reals: ...
def alpha(theta: _Reals, theta_rate: _Reals) -> _Reals: ...
def rolling_half_sine(theta: _Reals, theta_rate: _Reals, elapsed: _Reals) -> _Reals: ...
def rolling_angle(theta: _Reals, theta_rate: _Reals, elapsed: _Reals) -> _Reals: ...
def rolling_time_to_plane(theta: _Reals, theta_rate: _Reals) -> _Reals: ...
def stable_manifold_rate(theta: _Reals) -> _Reals: ...
def unstable_manifold_rate(theta: _Reals) -> _Reals: ...
def rolling_normal(theta: _Reals, theta_rate: _Reals) -> _Reals: ...
def rolling_friction(theta: _Reals, theta_rate: _Reals) -> _Reals: ...
def in_rolling_region(theta: _Reals, theta_rate: _Reals, mu_s: _Reals) -> npt.NDArray[np.bool_]: ...
def rolling_type(energy: _Reals, mu_s: _Reals) -> npt.NDArray[np.uint8]: ...
def slip_angle(mu_s: _Reals, offset: _Reals) -> _Reals: ...
def slip_time_from_top(theta_rate: _Reals, mu_s: _Reals) -> _Reals: ...
def unloading_time_from_top(theta_rate: _Reals) -> _Reals: ...
def gliding_time_to_plane(theta: _Reals, theta_rate: _Reals) -> _Reals: ...
def gliding_path(theta: _Reals, theta_rate: _Reals, slip: _Reals, elapsed: _Reals) -> tuple[_Reals, _Reals]: ...
