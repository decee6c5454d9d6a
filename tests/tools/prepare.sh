# shellcheck shell=bash
# Sourced by ./run, ./test and the scripts beside it: installs the Debian packages that are missing,
# configures, builds. What it says goes to stderr, so that stdout is the caller's; logs go to build/.
# Sets `root`, the root of the repository.

# With an exported CDPATH, cd prints where it goes.
unset CDPATH
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

# clang-format and clang-tidy judge differently from version to version: one version for every machine.
# shellcheck disable=SC2034  # used by the scripts that source this one
llvm=14
build_packages=(cmake ninja-build g++ libboost-dev libboost-filesystem-dev libcli11-dev libfmt-dev
  nlohmann-json3-dev libpng-dev libsdl2-dev libssl-dev libtinyobjloader-dev zlib1g-dev
  libzydis-dev nasm libunicorn-dev z3 libfixmath-dev libfreetype-dev)
test_packages=("${build_packages[@]}" ccache libgtest-dev librapidcheck-dev libbenchmark-dev libeigen3-dev
  libglm-dev libmpfr-dev libsimavr-dev gappa dosbox cvc5 python3-yaml python3-jsonschema python3-markdown-it)
# shellcheck disable=SC2034  # used by ./test
wasm_packages=(clang lld wasi-libc "libc++-$llvm-dev-wasm32" "libc++abi-$llvm-dev-wasm32"
  "libclang-rt-$llvm-dev-wasm32" python3)
# shellcheck disable=SC2034  # used by ./run
site_packages=(python3 python3-markdown-it)
# shellcheck disable=SC2034
browser_packages=(chromium chromium-driver python3-selenium nodejs "${wasm_packages[@]}")
# shellcheck disable=SC2034
import_packages=(clang git pkg-config)
# shellcheck disable=SC2034
scale_packages=(parallel procps slurmctld slurmd slurm-client munge)
# shellcheck disable=SC2034
language_packages=(rustc golang-go mono-mcs mono-runtime nodejs iverilog verilator ghdl)
# shellcheck disable=SC2034
processor_packages=(gcc-arm-none-eabi gcc-aarch64-linux-gnu gcc-riscv64-unknown-elf gcc-mips-linux-gnu
  gcc-mipsel-linux-gnu gcc-m68k-linux-gnu gcc-powerpc-linux-gnu gcc-s390x-linux-gnu
  gcc-sparc64-linux-gnu gcc-avr avr-libc python3)
# shellcheck disable=SC2034
packaging_packages=(git dpkg-dev binutils zip xz-utils g++-aarch64-linux-gnu qemu-user)
# Libraries of the command for AArch64: app/packages/sysroot unpacks them below build/, without installing them.
# shellcheck disable=SC2034
arm64_packages=(libc6 gcc-12-base libgcc-s1 libstdc++6 libboost1.74-dev libboost-filesystem1.74-dev libboost-system1.74-dev
  libcli11-dev libfmt-dev libfmt9 nlohmann-json3-dev libpng-dev libssl-dev libtinyobjloader-dev libtinyobjloader2rc10
  zlib1g-dev libzycore-dev libzycore1.4 libzydis-dev libzydis4.0 libunicorn-dev libunicorn2)
# shellcheck disable=SC2034  # used by ./test, to try the packages
bare_packages=(debootstrap meson gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib)
# shellcheck disable=SC2034
python_packages=(python3 python3-numpy python3-pytest python3-hypothesis python3-pip python3-setuptools python3-wheel)

say() { printf 'fixproof: %s\n' "$*" >&2; }
die() { say "$*"; exit 2; }

# Ends if there is no room for the temporary files of compilers: their messages do not name the folder.
require_room() {
  local folder=${TMPDIR:-/tmp} file
  if ! file=$(mktemp "$folder/fixproof.XXXXXX" 2>/dev/null) || ! head -c 1048576 /dev/zero 2>/dev/null >"$file"; then
    rm -f "$file"
    die "no room for temporary files in $folder; make some, or set TMPDIR to another folder"
  fi
  rm -f "$file"
}

# install_packages WHY PACKAGE...
install_packages() {
  local why=$1; shift
  if ! command -v dpkg-query >/dev/null; then
    say "not a Debian or Ubuntu system; going on as if these were installed: $*"
    return
  fi
  local package missing=()
  for package; do
    dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed ||
      missing+=("$package")
  done
  ((${#missing[@]})) || return 0

  local by_hand="apt-get update && apt-get install --no-install-recommends ${missing[*]}"
  local as_root=()
  if [[ $(id -u) != 0 ]]; then
    command -v sudo >/dev/null || die "packages are missing ($why); as root, run: $by_hand"
    as_root=(sudo)
  fi
  say "installing with ${as_root[*]:+sudo }apt-get ($why): ${missing[*]}"
  local log=$root/build/packages.log
  local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y
    -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=120)
  mkdir -p "$root/build"
  # A failed update is not the end: the lists that are there may be enough. Installing decides.
  "${apt[@]}" update >"$log" 2>&1 || true
  if ! "${apt[@]}" install --no-install-recommends "${missing[@]}" >>"$log" 2>&1; then
    tail -n 12 "$log" >&2
    die "apt-get failed (no network?), see $log; then, as root, run: $by_hand"
  fi
}

# ccache, which ./test installs, lets another clone or branch build in a fraction of the time; nothing needs it. Paths
# are hashed relative to the root, so that clones share.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_MAXSIZE=10G
export CCACHE_SLOPPINESS=time_macros,include_file_mtime,include_file_ctime

# configure PRESET [CMAKE OPTION]...: parts left out for want of a library are named.
configure() {
  local preset=$1; shift
  local log=$root/build/$preset-configure.log
  require_room
  mkdir -p "$root/build"
  if command -v ccache >/dev/null; then set -- -D CMAKE_CXX_COMPILER_LAUNCHER=ccache "$@"; fi
  say "configuring and building in $root/build/$preset"
  if ! (cd "$root" && cmake --preset "$preset" "$@") >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    die "configuring failed, see $log"
  fi
  sed -n 's/^-- \(.*: not built, .*\)/fixproof: \1/p' "$log" >&2
}

# build PRESET [TARGET]: everything, or one target.
build() {
  local preset=$1 target=${2:-all}
  CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)} \
    cmake --build "$root/build/$preset" --target "$target" >&2 ||
    die "building '$target' in $root/build/$preset failed, see above"
}

# configure_with_tests PRESET [CMAKE OPTION]...: a missing test library is an error, never a smaller set of tests.
configure_with_tests() {
  local packages=("${test_packages[@]}")
  # sanitize is built with it too.
  [[ $1 == release || $1 == nightly ]] || packages+=(clang "libclang-rt-$llvm-dev")
  install_packages "needed to build Fixproof and its tests" "${packages[@]}"
  configure "$1" -D BUILD_TESTING=ON -D CMAKE_REQUIRE_FIND_PACKAGE_GTest=ON \
    -D CMAKE_REQUIRE_FIND_PACKAGE_rapidcheck=ON -D CMAKE_REQUIRE_FIND_PACKAGE_benchmark=ON "${@:2}"
}

# files_named PATTERN...: files of the tree by name, NUL-separated, sorted; without git.
files_named() {
  local pattern match=()
  for pattern; do match+=(-o -name "$pattern"); done
  (cd "$root" && find . -mindepth 1 \( -name build -o -name '.*' \) -type d -prune \
    -o -type f \( "${match[@]:1}" \) -print0 | sort -z)
}
