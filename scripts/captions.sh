#!/usr/bin/env bash
# Sets the captions of all figures with LaTeX: those of the paper's hoops and of hoops with unusual numbers, dimensionless and in SI units.
# Needs pdflatex (on Debian texlive-latex-base). `scripts/captions.sh PROGRAM` takes a program that is built.
set -euo pipefail
cd "$(dirname "$0")/.."

command -v pdflatex >/dev/null || { echo "error: pdflatex is not there (on Debian: apt-get install texlive-latex-base)" >&2; exit 1; }
program="${1:-}"
if [ -z "$program" ]; then
  cargo build --release --locked --features figures
  program=target/release/littlewood
fi
program="$(realpath "$program")"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT

hoops=(
  ""
  "--case figure-7"
  "--case figure-3-bounces"
  "--case painleve"
  "--case figure-3 --mu-s 0.5 --mu-k 0.5"
  "--case figure-3 --mu-s 0 --mu-k 0"
  "--case figure-3 --restitution 1 --until 40"
  "--mass-ratio 0.001 --offset 1 --inertia 0.001 --mu-s 0.5 --mu-k 0.4 --theta 1.5 --theta-rate 1"
  "--mass-ratio 1 --offset 0 --inertia 1 --mu-s 0.5 --mu-k 0.4 --theta 1.5 --theta-rate 2 --slip 1"
  "--mass-ratio 1000 --offset 1 --inertia 1000 --mu-s 0.5 --mu-k 0.4 --theta 1.5 --theta-rate 2"
  "--mass-ratio 0 --offset 0.6 --inertia 0 --mu-s 0.5 --mu-k 0.4 --theta 1.5 --theta-rate 0.3"
  "--case figure-3 --particle-mass-kg 0.14 --radius-m 0.45"
  "--case figure-3-bounces --particle-mass-kg 0.14 --radius-m 0.45"
)
cd "$work"
number=0
for hoop in "${hoops[@]}"; do
  number=$((number + 1))
  mkdir "$number"
  # shellcheck disable=SC2086 # flags are words
  "$program" figures $hoop --format tex,pdf --out "$number" >/dev/null
  {
    printf '%s\n' '\documentclass{article}\usepackage{amsmath}\usepackage{graphicx}\extrafloats{100}\begin{document}'
    printf '\\graphicspath{{%s/}}\n' "$number"
    for caption in "$number"/*.tex; do printf '\\input{%s}\\clearpage\n' "$caption"; done
    printf '%s\n' '\end{document}'
  } >"hoop-$number.tex"
  pdflatex -interaction=nonstopmode -halt-on-error "hoop-$number.tex" >log 2>&1 || { grep -A 6 '^!' log >&2; echo "error: hoop '$hoop'" >&2; exit 1; }
  if grep -E 'Missing character|Overfull \\hbox \(([2-9][0-9]|[0-9]{3,})' log; then
    echo "error: hoop '$hoop'" >&2
    exit 1
  fi
  echo "$(find "$number" -name '*.tex' | wc -l) captions of '${hoop:-the cases of the paper}'"
done
