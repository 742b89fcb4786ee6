"""The documentation as a site: the documents of the repository, where they stand."""

import os
import sys
import tomllib
from pathlib import Path

_HERE = Path(__file__).parent
_ROOT = _HERE.parents[1]
sys.path.insert(0, str(_HERE / "extensions"))

_workspace = tomllib.loads((_ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"][
    "package"
]

project = "littlewood"
author = "The littlewood authors"
copyright = "the littlewood authors; MIT or Apache-2.0"
version = release = _workspace["version"]

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "formulas",
    "docstrings",
    "frames",
    "landmarks",
    "programs",
    "repository",
    "tables",
]

# The source folder is the repository, so that documents and their links stay where GitHub shows
# them, too.
root_doc = "docs/index"
source_suffix = {".md": "markdown"}
include_patterns = [
    "DESIGN.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "docs/*.md",
    "docs/**/*.md",
    "python/docs/*.md",
    "evidence/README.md",
    "findings/README.md",
    "evidence/bench/README.md",
    "evidence/reference/README.md",
    "evidence/truth/families.md",
]
exclude_patterns = [
    "target",
    "**/node_modules",
    "**/.venv",
    "**/.git",
    "crates",
    "web",
    "docs/site",
    ".github",
    "python/littlewood",
]

repository_url = _workspace.get("repository")

myst_enable_extensions = [
    "amsmath",
    "attrs_block",
    "attrs_inline",
    "colon_fence",
    "deflist",
    "dollarmath",
    "substitution",
]
myst_heading_anchors = 4

# Documents have the quotation marks and dashes that they mean, and flags have two hyphens.
smartquotes = False

numfig = True
numfig_secnum_depth = 1
math_numfig = True
math_eqref_format = "(T{number})"

default_role = "literal"
autodoc_typehints = "none"
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True}
napoleon_numpy_docstring = True
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True
napoleon_preprocess_types = True
napoleon_type_aliases = {
    "array_like": ":data:`array_like <numpy.typing.ArrayLike>`",
    "ndarray": "~numpy.ndarray",
    "scalar": "``scalar``",
    "int8": "~numpy.int8",
    "uint8": "~numpy.uint8",
    "uint64": "~numpy.uint64",
    "Path": "~pathlib.Path",
    "mapping": "~collections.abc.Mapping",
    "iterable": "~collections.abc.Iterable",
    "collection": "~collections.abc.Collection",
    # No pages of their own.
    **{name: f"``{name}``" for name in ("Animation", "Laboratory", "callable")},
}
python_display_short_literal_types = True
python_use_unqualified_type_names = True
toc_object_entries_show_parents = "hide"

copybutton_prompt_text = r"\$ |>>> |\.\.\. "
copybutton_prompt_is_regexp = True
copybutton_only_copy_prompt_lines = True

nitpicky = True
# Of names that are not ours, those of these packages: intersphinx links them where
# LITTLEWOOD_INTERSPHINX asks for it, since that needs a network.
_OTHERS = {
    "python": "https://docs.python.org/3",
    "numpy": "https://numpy.org/doc/stable",
    "scipy": "https://docs.scipy.org/doc/scipy",
    "pandas": "https://pandas.pydata.org/docs",
    "xarray": "https://docs.xarray.dev/en/stable",
    "matplotlib": "https://matplotlib.org/stable",
}
_BUILT_IN = (
    r"(bool|bytes|complex|dict|float|int|list|object|set|str|tuple|None|[A-Z]\w*Error"
    r"|collections\.abc\.\w+|contextlib\.\w+|pathlib\.Path|os\.PathLike)"
)
nitpick_ignore_regex = [(r"py:\w+", rf"({'|'.join(_OTHERS)})\..*|{_BUILT_IN}")]
if os.environ.get("LITTLEWOOD_INTERSPHINX"):
    extensions.append("sphinx.ext.intersphinx")
    intersphinx_mapping = {name: (address, None) for name, address in _OTHERS.items()}
suppress_warnings: list[str] = []

html_theme = "furo"
html_title = "littlewood"
html_short_title = "littlewood"
html_static_path = ["static"]
templates_path = ["templates"]
html_css_files = ["site.css"]
html_search_scorer = str(_HERE.resolve() / "scorer.js")
html_js_files = [(name, {"defer": "defer"}) for name in ("frames.js", "scroll.js", "sort.js")]
html_favicon = "../../web/public/icon.svg"
html_copy_source = False
html_show_sphinx = False
html_additional_pages = {"index": "index.html"}
html_theme_options = {
    "top_of_page_buttons": [],
    "light_css_variables": {
        "color-brand-primary": "#5b2a91",
        "color-brand-content": "#5b2a91",
        "color-brand-visited": "#5b2a91",
    },
    "dark_css_variables": {
        "color-brand-primary": "#c9a7f5",
        "color-brand-content": "#c9a7f5",
        "color-brand-visited": "#c9a7f5",
    },
}
