"""The tables of DESIGN.md on our own code and the code of others: lines by part, and packages.

python3 scripts/own_code.py              writes the tables anew
python3 scripts/own_code.py --check      fails where a number of them is wrong by more than a tenth
python3 scripts/own_code.py --libraries  counts anew, over a network, what each library would add;
                                         copy the numbers into PARTS below
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

root = Path(__file__).resolve().parents[1]
DESIGN = root / "DESIGN.md"
START, END = "<!-- own code -->\n", "<!-- /own code -->\n"
TOLERANCE = 0.1

# What we wrote although a library has it: part, files, libraries with the packages that each adds,
# the reason.
PARTS = [
    (
        "frames, ticks, keys, labels, hatches, perspective",
        "crates/littlewood-draw/src/*.rs -font.rs -letters.rs -svg.rs -pdf.rs -raster.rs -csv.rs",
        {"plotters": 23},
        "see *No plotting library*",
    ),
    (
        "SVG, PDF and pixels, on pdf-writer and tiny-skia",
        "crates/littlewood-draw/src/{svg,pdf,raster}.rs",
        {"krilla": 37, "svg2pdf": 48},
        "one list of shapes for all three",
    ),
    (
        "letters as outlines and as a font",
        "crates/littlewood-draw/src/{font,letters}.rs",
        {"write-fonts": 16, "subsetter": 12},
        "see *Letters are outlines*",
    ),
    (
        "Zarr v3, one codec",
        "crates/littlewood-sweep/src/zarr/*.rs",
        {"zarrs": 79},
        "metadata, and one codec around chunks that are files",
    ),
    (
        "text tables",
        "crates/littlewood-report/src/sheet.rs",
        {"comfy-table": 11},
        "facts, notes, folded phases and what fits a terminal are ours with either",
    ),
    (
        "error messages with the line of the file",
        "crates/littlewood-cli/src/error/{mod,excerpt}.rs",
        {"miette": 3},
        "a hint, a bound and an exit code for each error are ours with either",
    ),
    (
        "HTTP: GET and HEAD of files in memory",
        "crates/littlewood-cli/src/lab/{http,answer}.rs",
        {"tiny_http": 4},
        "it reads a body into memory of the size that the request claims",
    ),
    (
        "the page inside the program",
        "crates/littlewood-cli/src/lab/assets.rs",
        {"rust-embed": 16},
        "a list that the build script writes",
    ),
    (
        "opening a browser",
        "crates/littlewood-cli/src/lab/browser.rs",
        {"webbrowser": 30},
        "one command for each system",
    ),
    (
        "numbers with derivatives",
        "crates/littlewood/src/math/number.rs",
        {"num-dual": 11},
        "std or libm by a feature, see *Equal bits everywhere*",
    ),
    (
        "elliptic integrals in Carlson's form",
        "crates/littlewood/src/math/carlson.rs",
        {"ellip": 3},
        "the same; ellip checks ours in the tests",
    ),
]

# The whole, by language.
WHOLE = {
    "Rust, the core": "crates/littlewood/src/**/*.rs",
    "Rust, the other crates": "crates/*/src/**/*.rs -littlewood/src",
    "Rust, tests, examples and benchmarks": "crates/*/{tests,examples,benches}/**/*.rs",
    "Python, the package": "python/littlewood/**/*.py",
    "Python, its tests": "python/tests/**/*.py",
    "Python, evidence: certificates, engines, studies": "evidence/**/*.py",
    "TypeScript, the page": "web/src/**/*.ts -generated -wasm",
    "TypeScript, its tests": "web/tests/**/*.ts",
    "shell and Python, scripts": "scripts/* test.sh */build.sh",
}

# The programs whose packages are counted, with the arguments of cargo tree.
PROGRAMS = {
    "the core": ["--package", "littlewood"],
    "the default program": ["--package", "littlewood-cli"],
    "the program with all features": ["--package", "littlewood-cli", "--features", "full"],
}


def run(command: list[str], folder: Path = root) -> str:
    return subprocess.run(command, cwd=folder, check=True, capture_output=True, text=True).stdout


def files(patterns: str) -> list[Path]:
    """Files in git of these patterns, without those whose path has what stands behind a minus."""
    wanted, without = [], []
    for pattern in patterns.split():
        if pattern.startswith("-"):
            without.append(pattern[1:])
            continue
        braces = re.search(r"\{(.*)\}", pattern)
        options = braces[1].split(",") if braces else [""]
        whole = braces[0] if braces else ""
        wanted += [":(glob)" + pattern.replace(whole, option) for option in options]
    listed = run(["git", "ls-files", "--", *wanted]).split("\n")
    return [
        root / it for it in listed if it and not any("/" + part in "/" + it for part in without)
    ]


def lines(patterns: str) -> int:
    """Lines as the formatter leaves them, comments among them, tests at the end of a file not."""
    counted = 0
    for path in files(patterns):
        text = path.read_text(encoding="utf-8")
        counted += text.partition("\n#[cfg(test)]\nmod tests")[0].count("\n")
    return counted


def packages(arguments: list[str], folder: Path = root) -> set[str]:
    """Packages of others, without those that only build or test."""
    tree = run(["cargo", "tree", "--edges", "normal", "--prefix", "none", *arguments], folder)
    # Those on this machine are ours.
    return {line.split(" (")[0].strip() for line in tree.splitlines() if line and "(/" not in line}


def tables() -> str:
    own = [
        f"| {part} | {lines(paths):,} | "
        + ", ".join(f"{library} {added}" for library, added in libraries.items())
        + f" | {reason} |"
        for part, paths, libraries, reason in PARTS
    ]
    whole = [f"| {part} | {lines(paths):,} |" for part, paths in WHOLE.items()]
    others = [
        f"| {program} | {len(packages(['--locked', *arguments]))} |"
        for program, arguments in PROGRAMS.items()
    ]
    return "\n".join(
        [
            "| ours although a library has it | lines | library, packages more | why |",
            "|---|---|---|---|",
            *own,
            "",
            "| packages of others in | |",
            "|---|---|",
            *others,
            "",
            "| lines in all | |",
            "|---|---|",
            *whole,
            "",
        ]
    )


def libraries() -> None:
    inside = {
        name.split()[0]
        for name in packages(["--locked", *PROGRAMS["the program with all features"]])
    }
    for _, _, names, _ in PARTS:
        for name in names:
            with tempfile.TemporaryDirectory() as work:
                run(["cargo", "init", "--lib", "--name", "empty", "--vcs", "none"], Path(work))
                run(["cargo", "add", "--quiet", name], Path(work))
                added = {it.split()[0] for it in packages([], Path(work))} - inside
            print(f"{name}: {len(added)}")


def numbers(text: str) -> list[int]:
    return [int(it.replace(",", "")) for it in re.findall(r"(?<= )\d[\d,]*(?= )", text)]


def main() -> None:
    if sys.argv[1:] == ["--libraries"]:
        libraries()
        return
    text = DESIGN.read_text(encoding="utf-8")
    before, _, rest = text.partition(START)
    stands, _, after = rest.partition(END)
    counted = tables()
    if sys.argv[1:] == ["--check"]:
        words = [re.sub(r"\d[\d,]*", "", it) for it in (stands, counted)]
        pairs = list(zip(numbers(stands), numbers(counted), strict=False))
        if words[0] != words[1] or any(abs(a - b) > TOLERANCE * b for a, b in pairs):
            sys.exit(
                "error: the tables of own code in DESIGN.md are stale: python3 scripts/own_code.py"
            )
        return
    DESIGN.write_text(f"{before}{START}{counted}{END}{after}", encoding="utf-8")


main()
