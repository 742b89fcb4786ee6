"""What a user writes, for mypy --strict: not run."""

import math

import numpy as np
import pandas as pd
import xarray

import littlewood as lw
from littlewood import closed_form, plot

hoop: lw.Hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
si: lw.Hoop = lw.Hoop.from_si(
    disc_mass_kg=0.4,
    particle_mass_kg=0.14,
    radius_m=0.45,
    offset_m=0.45,
    inertia_kg_m2=0.08,
    mu_s=0.5,
    mu_k=0.4,
)
motion: lw.Trajectory = hoop.simulate(theta=math.pi / 2, theta_rate=2, until=30.0)
bouncy: lw.Hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=0.5)
law: str | None = bouncy.restitution_law
impacts: pd.DataFrame = bouncy.simulate(theta=0.0, theta_rate=0.0, gap_rate=1.0).impacts()
before: lw.Samples = motion(1.0, side="before")
hops: xarray.Dataset = lw.outcome_map(
    bouncy, theta=[0.0], theta_rate=1.0, restitution=[0.1], restitution_law="poisson"
)
orbit: lw.bouncing.BouncingOrbit | None = bouncy.bouncing_orbit(1.0)
modes: list[str] = [phase.mode for phase in motion.phases]
times: list[float] = [transition.time for transition in motion.transitions]
kind: str = motion.outcome.kind
samples: lw.Samples = motion(np.linspace(0.0, 1.0, 5))
largest: float = float(np.max(samples.normal))
text: str | None = motion.to_json(samples=11)
dataset: xarray.Dataset = motion.to_xarray(si=False)
gradient: xarray.Dataset = motion.derivatives(["mu_k", "theta_rate"])
at_times: xarray.Dataset = motion.derivatives_at([0.5, 1.0])
many: xarray.Dataset = lw.simulate_many(
    hoop, theta=[0.0, 1.0], theta_rate=1.0, mu_k=np.array([0.1, 0.2])
)
plane: xarray.Dataset = lw.outcome_map(
    hoop, theta=np.zeros(2), mu=[0.4, 0.5], theta_rate=1.0, chunks="auto"
)
angle: float = float(closed_form.slip_angle(0.5))
inside: bool = bool(hoop.phase_plane.in_rolling_region(0.5, 0.2))
result: lw.FitResult = lw.fit(
    lw.Track(np.arange(9.0), theta=np.zeros(9)), hoop, free=("mu_k",), sigma={"theta": 0.01}
)
error: float = result.estimates["mu_k"].std_error
motion.plot().savefig("motion.png")
plot.outcomes(plane).set_title("outcomes")
motion.animate(frames=10).save("motion.gif")
camera: lw.video.Camera = lw.video.Camera((0.0, 1.0, 4.0), (0.0, 0.5, 0.0), focal_px=1000.0)
plane_of_motion: lw.video.Plane = lw.video.Plane.from_camera(camera)
filmed: lw.Track = lw.track_video("film.mp4", si, plane=plane_of_motion, fps=240.0, marker="green")
interval: tuple[float, float] = result.estimates["mu_k"].interval(0.9)
written: int = lw.video.overlay_video(
    "film.mp4", result, "both.mp4", plane=plane_of_motion, fps=240.0
)
