# Clang 14 of Debian, for the scripts that need it: sanitizers, fuzzing, the second compiler. Sourced after common.sh.
clang=clang++-14
clang_packages=(clang-14 libclang-rt-14-dev) # the compiler; sanitizers and libFuzzer

have_clang() { command -v "$clang" >/dev/null && compgen -G "/usr/lib/llvm-14/lib/clang/*/lib/linux/*fuzzer*" >/dev/null; }

need_clang() {
  have_clang && return
  say "installing ${clang_packages[*]}"
  local as_root=()
  [[ "$(id -u)" -eq 0 ]] || as_root=(sudo)
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install --yes --no-install-recommends \
    "${clang_packages[@]}" </dev/null >/dev/null || fail "apt-get could not install ${clang_packages[*]}"
}
