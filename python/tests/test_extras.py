import subprocess
import sys

import pytest

# The extra that a call names when a module is not there.
CALLS = [
    ("xarray", "xarray", "lw.simulate_many(hoop, theta=[0.0], theta_rate=1.0)"),
    ("xarray", "xarray", "import littlewood.jax; lw.jax.summary(['end_x'], hoop, theta=1.0)"),
    ("pandas", "xarray", "motion.to_pandas()"),
    ("pandas", "xarray", "motion.impacts()"),
    ("dask", "dask", "lw.outcome_map(hoop, theta=[0.0, 1.0], theta_rate=1.0, chunks=1)"),
    ("matplotlib", "plot", "motion.plot()"),
    ("matplotlib", "plot", "motion.animate().to_matplotlib()"),
    ("scipy", "fit", "lw.fit(lw.Track(np.arange(9.0), theta=np.arange(9.0) / 9), hoop)"),
    ("cv2", "video", "lw.video.rate_of('film.avi')"),
    ("tqdm", "progress", "lw.simulate_many(hoop, theta=[0.0], theta_rate=1.0, progress=True)"),
]

SCRIPT = """
import sys
sys.modules[{module!r}] = None
import numpy as np
import littlewood as lw
motion = lw.case("figure-3").simulate()
hoop = motion.hoop
motion(np.zeros(3)), str(motion), motion._repr_html_(), lw.closed_form.alpha(0.0, [1.0])
try:
    {call}
except ImportError as error:
    print(error)
"""


@pytest.mark.parametrize(("module", "extra", "call"), CALLS)
def test_a_missing_extra_is_named(module, extra, call):
    # `None` in sys.modules is how Python marks a module that is not to be imported.
    script = SCRIPT.format(module=module, call=call)
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert f'{module}, which is not installed: pip install "littlewood[{extra}]"' in done.stdout


def test_numpy_is_enough():
    heavy = (
        "xarray pandas dask distributed zarr matplotlib scipy tqdm cv2 jax torch anywidget flint"
    )
    script = f"import sys, littlewood; print(*[m for m in {heavy.split()!r} if m in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == []


def test_scipy_is_enough_for_a_fit():
    # A motion that slides, without heights: the fit takes its exact derivatives.
    script = """
import sys
for module in "xarray pandas matplotlib tqdm cv2".split():
    sys.modules[module] = None
import numpy as np
import littlewood as lw
motion = lw.case("figure-3").simulate(until=0.5)
time = np.linspace(0.0, 0.5, 60)
track = lw.Track(time, theta=motion(time).theta, x=motion(time).x)
result = lw.fit(track, motion.hoop, free=["mu_k"], search=False, sigma={"theta": 0.01, "x": 0.01})
print(abs(result.hoop.mu_k - motion.hoop.mu_k) < 1e-6)
"""
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=False
    )
    assert done.stdout.split() == ["True"], done.stderr
