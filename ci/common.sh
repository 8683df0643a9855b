# What the scripts of this folder share. Sourced, never run: `source "$(dirname "${BASH_SOURCE[0]}")/common.sh"`.
# Leaves the shell at the root of the repository, whatever the working directory was.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
cd "$root"

script="ci/$(basename "$0")"
build="build/release"   # everything that is compiled
records="build/records" # what the verification and the benchmarks leave for the report
jobs="$(nproc)"

say() { printf '[%s] %s\n' "$script" "$*"; }
fail() {
  printf '[%s] FAILED: %s\n' "$script" "$*" >&2
  exit 1
}
trap 'printf "[%s] FAILED in line %s: %s\n" "$script" "$LINENO" "$BASH_COMMAND" >&2' ERR

# The interpreter that has Debian's matplotlib: another python3 may come first on the path.
find_python() {
  local candidate
  for candidate in /usr/bin/python3 python3 /usr/local/bin/python3; do
    if command -v "$candidate" >/dev/null && "$candidate" -c 'import matplotlib, jinja2, numpy, h5py' 2>/dev/null; then
      command -v "$candidate"
      return
    fi
  done
  return 1
}
