# What the scripts share, for them to source: folders, environments, and what is built once. It goes to the root of the repository.
# shellcheck shell=bash disable=SC2034,SC2164 # its variables are for the others, which have `set -e`
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root="$PWD"
case "${CARGO_TARGET_DIR:-}" in
  "") target="$root/target" ;;
  /* | ?:*) target="$CARGO_TARGET_DIR" ;;
  *) target="$root/$CARGO_TARGET_DIR" ;;
esac
[ -z "${CARGO_TARGET_DIR:-}" ] || export CARGO_TARGET_DIR="$target"
# One set of features throughout, so that clippy, rustdoc and the tests share what they build; and the program that the tests of Python
# and of the page compare with is that of the tests of Rust.
everything=(--workspace --all-features --locked)
export LITTLEWOOD_BIN="${LITTLEWOOD_BIN:-$target/debug/littlewood}"
python="$target/venv/bin/python"

# uv MORE…: the one of this machine, or that of PyPI.
uv() {
  if ! command uv --version >/dev/null 2>&1; then
    [ -x "$target/uv/bin/uv" ] || { "${PYTHON:-python3}" -m venv "$target/uv" && "$target/uv/bin/python" -m pip install --quiet "uv>=0.9,<1"; }
    PATH="$target/uv/bin:$PATH" command uv "$@"
  else
    command uv "$@"
  fi
}

# The Python of all tests, target/venv, with what python/uv.lock lists; PYTHON names the interpreter that it is made of.
python_environment() {
  UV_PROJECT_ENVIRONMENT="$target/venv" uv sync --quiet --project python --frozen --inexact --no-install-project \
    --all-extras --no-extra torch --all-groups --no-python-downloads --python "${PYTHON:-python3}"
}

# The packages of npm that web/package-lock.json lists.
npm_packages() {
  local installed=web/node_modules/.installed-from
  cmp --silent web/package-lock.json "$installed" && return
  (cd web && npm ci --no-fund --no-audit)
  cp web/package-lock.json "$installed"
}

# Chromium and a compiler for WebAssembly, on Debian, as root.
browser() {
  local missing=()
  [ -x "${CHROMIUM:-/usr/bin/chromium}" ] || missing+=(chromium fonts-dejavu-core)
  if [ ! -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ]; then
    # The standard library for WebAssembly, or the sources that it can be built from.
    timeout 30 rustup target add wasm32-unknown-unknown >/dev/null 2>&1 ||
      { [ -x /usr/bin/rustc ] && [ -d /usr/lib/rustlib/src/rust/library/std ]; } || missing+=(rustc-web rust-web-src)
  fi
  [ "${#missing[@]}" = 0 ] && return
  apt-get update
  DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# built: the programs and libraries of the tests of Rust, and the wheel that is packed from them, installed. Once: LITTLEWOOD_BUILT
# says that they are there.
built() {
  [ -z "${LITTLEWOOD_BUILT:-}" ] || return 0
  python/build.sh
  export LITTLEWOOD_BUILT=1
}
