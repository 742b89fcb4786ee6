"""Where metadata has to stand a second time, it is that of Cargo.toml.

In CITATION.cff, the Python package and the page.
"""

import json
import sys
import tomllib
from pathlib import Path

root = Path(__file__).parents[1]
package = tomllib.loads((root / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]
citation = (root / "CITATION.cff").read_text(encoding="utf-8")
python = tomllib.loads((root / "python" / "pyproject.toml").read_text(encoding="utf-8"))["project"]
page = json.loads((root / "web" / "package.json").read_text(encoding="utf-8"))

checks = {
    "CITATION.cff, version": f"\nversion: {package['version']}\n" in citation,
    "CITATION.cff, repository-code": f"\nrepository-code: {package['repository']}\n" in citation,
    "pyproject.toml, Repository": python["urls"]["Repository"] == package["repository"],
    "pyproject.toml, Changelog": python["urls"]["Changelog"]
    == f"{package['repository']}/blob/main/CHANGELOG.md",
    "pyproject.toml, description": python["description"] == package["description"],
    "package.json, version": page["version"] == package["version"],
}
wrong = [where for where, agrees in checks.items() if not agrees]
for where in wrong:
    print(f"error: {where} differs from Cargo.toml", file=sys.stderr)
sys.exit(bool(wrong))
