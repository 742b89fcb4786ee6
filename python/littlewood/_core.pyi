from collections.abc import Callable, Sequence
from typing import Any, TypedDict, final

import numpy as np
import numpy.typing as npt

# Numbers in the order of START and SI_START.
_Numbers = Sequence[float]
# Numbers in the order of HOOP and SI_HOOP, of which some may be absent.
_HoopNumbers = Sequence[float | None]
# The numbers of a hoop and the name of its law of restitution.
_Hoop = tuple[_HoopNumbers, str | None]
_Scales = tuple[float, float, float]
_Reals = npt.NDArray[np.float64]
_Pair = tuple[float, float]
_Pieces = list[list[list[float]]]
# Numbers of a hoop by the names of HOOP, and those of a start by the names of START.
_HoopByName = dict[str, Any]
_StartByName = dict[str, Any]

class _State(TypedDict):
    time: float
    theta: float
    theta_rate: float
    slip: float
    x: float

class _Velocities(TypedDict):
    theta_rate: float
    slip: float
    gap_rate: float

class _Impulse(TypedDict):
    normal: float
    friction: float

class _Impact(TypedDict):
    case: str
    before: _Velocities
    after: _Velocities
    impulse: _Impulse
    normal_work: float
    friction_work: float
    resistance_work: float
    energy_lost: float
    gains_energy: bool

class _Transition(TypedDict):
    before: _State
    after: _State
    impact: _Impact | None
    from_mode: str | None
    to_mode: str | None
    direction: int
    cause: str

class _Phase(TypedDict):
    mode: str
    direction: int
    start: _State
    end: _State | None
    energy_start: float
    energy_lost: float
    is_small_inertia_limit: bool
    ended_by: int | None

class _Outcome(TypedDict):
    kind: str
    state: _State
    details: dict[str, Any]
    sentence: str

class _Row(TypedDict):
    mode: str | None
    cells: list[str]

class _Block(TypedDict):
    kind: str
    head: list[str]
    rows: list[_Row]
    numbers: list[int]

# Derivatives row after row: the columns by their names, and the reasons why there are none.
class _Rows(TypedDict):
    columns: dict[str, _Reals]
    reasons: list[str]

class _DerivativesOfMotion(TypedDict):
    quantities: list[str]
    transitions: _Rows
    outcome: _Rows
    recurrence: dict[str, list[float]]

class _DerivativesAtTimes(TypedDict):
    quantities: list[str]
    rows: _Rows

class _DerivativeColumn(TypedDict):
    quantity: str
    long_name: str
    unit: str
    scale: str

class _Equilibrium(TypedDict):
    theta: float
    stability: str
    rate: float

class _BouncingOrbit(TypedDict):
    top_rate: float
    bottom_rate: float
    gap_rate: float
    friction: float
    period: float
    start: _StartByName

class _ClassAt(TypedDict):
    value: float
    class_name: str

class _Threshold(TypedDict):
    sides: list[_ClassAt] | None
    has_unresolved_between: bool
    text: str

class _DerivedHoop(TypedDict):
    mass: float
    h: float
    inertia_about_mass_centre: float
    restitution_law: str | None

class _Units(TypedDict):
    mass_kg: float
    length_m: float
    time_s: float
    gravity_m_per_s2: float

class _HoopFromSi(TypedDict):
    hoop: _HoopByName
    units: _Units

class _StartFromSi(TypedDict):
    start: _StartByName
    until: float | None

class _DerivedUnits(TypedDict):
    rate_rad_per_s: float
    velocity_m_per_s: float
    force_n: float
    energy_j: float
    inertia_kg_m2: float

class _Refusal(TypedDict):
    key: str
    text: str
    reason: str

class _Link(TypedDict):
    refusal: _Refusal | None
    has_problem: bool
    at: float | None

class _Problem(TypedDict):
    hoop: _HoopByName
    restitution_law: str | None
    units: _Units | None
    start: _StartByName
    until: float | None

class _Case(TypedDict):
    name: str
    title: str
    source: str
    hoop: _HoopByName
    restitution_law: str | None
    start: _StartByName

class _Edge(TypedDict):
    body: str
    from_mode: str | None
    cause: str
    guard: str
    reset: str
    to_mode: str | None
    source: str

class _Code(TypedDict):
    code: int
    name: str

class _Coded(_Code):
    label: str

class _OutcomeRow(_Coded):
    is_final: bool

class _Axis(TypedDict):
    name: str
    sign: str
    long_name: str

class _Counts(TypedDict):
    least: int
    most: int

class _Colour(TypedDict):
    group: str
    name: str
    colour: str

class _Tick(TypedDict):
    value: float
    label: str

class _Dash(TypedDict):
    group: str
    name: str
    pattern: list[float]

class _Curve(TypedDict):
    name: str
    letter: str | None
    width: float

class _DrawnCurve(TypedDict):
    pieces: _Pieces
    place_of_letter: list[float] | None

__version__: str
AXES: list[str]
CAUSES: list[_Coded]
CLASSES: list[_Coded]
FRICTION: _Axis
HOOP: list[str]
IMPACT_CASES: list[_Coded]
MAX_SLIDES: int
MAX_TRANSITIONS: int
PROOF: str
PROOFS: list[str]
MOST_THREADS: int
PRINT_WIDTHS_MM: tuple[float, float]
MODES: list[_Code]
MOST_POINTS: int
MOST_COUNT: int
OUTCOMES: list[_OutcomeRow]
OUTSIDE: int
PHASES: list[_Coded]
REGIONS: list[_Code]
RESTITUTION_LAWS: list[_Coded]
ROLLING_TYPES: list[_Code]
SAMPLE_COUNTS: _Counts
SEQUENCE_CAPACITY: int
SEQUENCE_ENCODING: str
SEQUENCE_VERSION: int
SI_HOOP: list[str]
SI_START: list[str]
STANDARD_GRAVITY: float
START: list[str]

class ParameterError(ValueError):
    quantity: str
    hint: str
    index: int | None

@final
class Trajectory:
    def phases(self) -> list[_Phase]: ...
    def transitions(self) -> list[_Transition]: ...
    def outcome(self) -> _Outcome: ...
    def text(self) -> str: ...
    def json(self, samples: int | None, scales: _Scales | None) -> str: ...
    def blocks(self) -> list[_Block]: ...
    def end_time(self) -> float: ...
    def shown_until(self) -> float: ...
    def energy_lost(self) -> float: ...
    def rolling_resistance_energy_lost(self) -> float: ...
    def impact_energy_lost(self) -> float: ...
    def sequence(self) -> str: ...
    def at(self, times: _Reals, is_before: bool) -> dict[str, npt.NDArray[Any]]: ...
    def sample_evenly(self, count: int, until: float) -> dict[str, npt.NDArray[Any]]: ...
    def derivatives(self, quantities: Sequence[str] | None) -> _DerivativesOfMotion: ...
    def derivatives_at(
        self, times: _Reals, quantities: Sequence[str] | None
    ) -> _DerivativesAtTimes: ...

@final
class PhasePlane:
    def __new__(cls, given: _Hoop) -> PhasePlane: ...
    def normal(self, theta: _Reals, theta_rate: _Reals) -> _Reals: ...
    def friction(self, theta: _Reals, theta_rate: _Reals) -> _Reals: ...
    def energy(self, theta: _Reals, theta_rate: _Reals) -> _Reals: ...
    def in_contact_region(self, theta: _Reals, theta_rate: _Reals) -> npt.NDArray[np.bool_]: ...
    def in_rolling_region(self, theta: _Reals, theta_rate: _Reals) -> npt.NDArray[np.bool_]: ...
    def normal_force_rate(self, theta: _Reals) -> _Reals: ...
    def positive_slip_rate(self, theta: _Reals) -> _Reals: ...
    def negative_slip_rate(self, theta: _Reals) -> _Reals: ...
    def lift_off_rate(self, theta: _Reals) -> _Reals: ...
    def separatrix_rate(self, theta: _Reals) -> _Reals: ...
    def reverse_chatter(self, theta: _Reals, theta_rate: _Reals) -> _Reals: ...
    def level_rate(self, theta: _Reals, energy: _Reals) -> _Reals: ...
    def curve(self, name: str, theta: _Pair, theta_rate: _Pair) -> _DrawnCurve | None: ...
    def orbits(self, theta: _Pair, theta_rate: _Pair, from_rest: int, over_top: int) -> _Pieces: ...
    def rolling_region(self, theta: _Pair, theta_rate: _Pair) -> _Pieces: ...
    def equilibria(self) -> list[_Equilibrium]: ...
    def regions(self, theta: _Reals, theta_rate: _Reals, slip: _Reals) -> npt.NDArray[np.uint8]: ...

def bouncing_orbit(given: _Hoop, angle: float) -> _BouncingOrbit | None: ...
def check_hoop(given: _Hoop) -> _DerivedHoop: ...
def check_until(until: float) -> None: ...
def check_proof(proof: str) -> None: ...
def hoop_from_si(numbers: _HoopNumbers, law_name: str | None) -> _HoopFromSi: ...
def start_from_si(scales: _Scales, numbers: _Numbers, until_s: float | None) -> _StartFromSi: ...
def sample_in_si(scales: _Scales, column: str, values: _Reals) -> _Reals: ...
def derived_units(scales: _Scales) -> _DerivedUnits: ...
def simulate(
    given: _Hoop,
    start_numbers: _Numbers,
    until: float | None,
    max_transitions: int,
    max_slides: int,
    proof: str,
) -> Trajectory: ...
def classify(given: _Hoop, start_numbers: _Numbers) -> dict[str, Any]: ...
def threshold(
    given: _Hoop,
    start_numbers: _Numbers,
    of: str,
    between: tuple[float, float] | None,
    until: float | None,
) -> _Threshold: ...
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
    derivatives: Sequence[str],
) -> dict[str, npt.NDArray[Any]]: ...
def derivative_column(name: str) -> _DerivativeColumn: ...
def classes(
    outcome: npt.NDArray[np.uint8], sequence: npt.NDArray[np.uint64], lift_off_time: _Reals
) -> npt.NDArray[np.uint8]: ...
def mixed(keys: npt.NDArray[np.uint8], columns: int) -> npt.NDArray[np.bool_]: ...
def read_link(link: str) -> _Link: ...
def problem_of_link(link: str) -> _Problem: ...
def write_link(
    given: _Hoop, start_numbers: _Numbers, until: float | None, at: float | None, shown: str
) -> str: ...
def quantities() -> list[dict[str, Any]]: ...
def sample_columns() -> list[dict[str, Any]]: ...
def summary_columns() -> list[dict[str, Any]]: ...
def swatches(dark: bool) -> list[_Colour]: ...
def dashes() -> list[_Dash]: ...
def curves() -> list[_Curve]: ...
def lengths() -> dict[str, float]: ...
def font() -> bytes: ...
def marked(sign: str) -> str: ...
def unicode(text: str) -> str: ...
def ticks(kind: str, a: float, b: float, most: int) -> list[_Tick]: ...
def digest_line(block: int) -> str: ...
def run_program(arguments: Sequence[str]) -> int: ...
def cases() -> list[_Case]: ...
def name_of_case(name: str) -> str | None: ...
def edges() -> list[_Edge]: ...
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
def gliding_path(
    theta: _Reals, theta_rate: _Reals, slip: _Reals, elapsed: _Reals
) -> tuple[_Reals, _Reals]: ...
