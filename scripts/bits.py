"""Compares the digests that the installed Python package computes with those committed."""

import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from littlewood import _core

digest = Path(__file__).parents[1] / "crates" / "littlewood-digest" / "digest.txt"
committed = digest.read_text(encoding="utf-8").splitlines()
with ThreadPoolExecutor() as threads:
    computed = list(threads.map(_core.digest_line, range(len(committed))))
pairs = [(ours, theirs) for ours, theirs in zip(committed, computed, strict=True) if ours != theirs]
for ours, theirs in pairs:
    print(f"committed {ours}\ncomputed  {theirs}")
print(f"{len(pairs)} of {len(committed)} blocks differ")
sys.exit(bool(pairs))
