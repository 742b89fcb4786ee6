#!/usr/bin/env bash
# Builds the paper, target/paper/paper.pdf: its numbers and figures are computed anew.
#
# Needs the package littlewood with Matplotlib (PYTHON names the interpreter), and tectonic or pdflatex (Debian: texlive-latex-recommended
# and texlive-fonts-recommended with lmodern).
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$0")/../../scripts/common.sh"
built

out="$target/paper"
mkdir -p "$out"
"$python" -m evidence.studies.paper "$out"
cp docs/paper/paper.tex "$out"
cd "$out"
if command -v tectonic >/dev/null; then
  tectonic paper.tex
else
  for _ in 1 2; do pdflatex -interaction=nonstopmode -halt-on-error paper.tex >pdflatex.txt || { tail -n 30 pdflatex.txt >&2 && exit 1; }; done
fi
echo "$out/paper.pdf"
