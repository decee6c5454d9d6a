#!/usr/bin/env bash
# The same bits everywhere: ./scripts/platforms --help
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/prepare.sh"

# Each: the processor, the triplet of Debian's cross compiler, what runs its programs here.
platforms=(
  "x86_64 x86_64-linux-gnu"
  "i686 i686-linux-gnu"
  "aarch64 aarch64-linux-gnu qemu-aarch64"
  "arm arm-linux-gnueabihf qemu-arm"
  "riscv64 riscv64-linux-gnu qemu-riscv64"
  "s390x s390x-linux-gnu qemu-s390x" # big-endian
)
flag_sets=("-O2")
operations=100000000
tests=1

usage() {
  cat <<'END'
usage: scripts/platforms [--operations N] [--digest-only] [PROCESSOR]...
Installs cross compilers and emulators (Debian packages, 1 GB), runs the type's tests on every PROCESSOR
(x86_64 i686 aarch64 arm riscv64 s390x), and computes one digest over N operations (default 10^8) there,
under g++ and clang++ at -O0 to -O3 and with -ffast-math. All digests must be equal. N = 10^6 takes some
minutes, 10^8 most of an hour. Exit status 0: all well. 1: a test failed, or digests differ. 2: could
not be built.
END
}

wanted=()
while (($#)); do
  case $1 in
    -h | --help) usage; exit ;;
    --digest-only) tests=0 ;;
    --operations)
      [[ ${2:-} =~ ^[1-9][0-9]{0,11}$ ]] || die "--operations takes a number from 1 to 999999999999"
      operations=$2
      shift ;;
    -*) die "no option '$1'; see --help" ;;
    *) printf '%s\n' "${platforms[@]}" | grep -q "^$1 " || die "no processor '$1'; see --help"
      wanted+=("$1") ;;
  esac
  shift
done

install_packages "needed to build for other processors" cmake ninja-build g++ "clang-$llvm" googletest \
  libboost-dev libfmt-dev qemu-user g++-{i686,aarch64,riscv64,s390x}-linux-gnu g++-arm-linux-gnueabihf

work=$root/build/platforms
mkdir -p "$work"
failed=0
declare -A digests

# run_tests PROCESSOR COMPILER [EMULATOR]
run_tests() {
  local log=$work/$1-tests.log
  if ! { cmake -S "$root/tests/platforms" -B "$work/$1" -G Ninja "-DCMAKE_CXX_COMPILER=$2" \
      '-DCMAKE_CXX_FLAGS=-O1 -Wno-psabi' && cmake --build "$work/$1"; } >"$log" 2>&1; then
    tail -n 25 "$log" >&2
    die "the tests do not build for $1, see $log"
  fi
  if ${3:+"$3"} "$work/$1/fixed_tests" --gtest_brief=1 >"$log" 2>&1; then
    printf '%-8s %-10s %-16s %s\n' "$1" g++ -O1 "$(grep -o '[0-9]* tests from' "$log" | head -n 1 | cut -d' ' -f1) tests passed"
  else
    failed=1
    tail -n 25 "$log" >&2
    printf '%-8s %-10s %-16s tests FAILED, see %s\n' "$1" g++ -O1 "$log"
  fi
}

# run_digest PROCESSOR NAME FLAGS EMULATOR COMPILER...
run_digest() {
  local processor=$1 name=$2 flags=$3 emulator=$4; shift 4
  local program=$work/digest answer
  # GNU's dialect, as users have it: on an i686 it defines i386. g++ for arm has notes on its ABI of old.
  # shellcheck disable=SC2086  # flags are words
  "$@" -std=gnu++20 $flags -Wno-psabi -static "-I$root" "$root/tests/platforms/digest.cpp" -o "$program" ||
    die "the digest does not build for $processor: $* $flags"
  answer=$(${emulator:+"$emulator"} "$program" "$operations") || { failed=1; answer="no answer, status $?"; }
  printf '%-8s %-10s %-16s %s\n' "$processor" "$name" "$flags" "$answer"
  digests[$answer]+="$processor $name $flags; "
}

for platform in "${platforms[@]}"; do
  read -r processor triplet emulator <<<"$platform"
  ((${#wanted[@]} == 0)) || [[ " ${wanted[*]} " == *" $processor "* ]] || continue
  ((tests == 0)) || run_tests "$processor" "$triplet-g++" "$emulator"
  for flags in "${flag_sets[@]}"; do
    run_digest "$processor" g++ "$flags" "$emulator" "$triplet-g++"
    run_digest "$processor" clang++ "$flags" "$emulator" "clang++-$llvm" "--target=$triplet"
  done
done

if ((${#digests[@]} != 1)); then
  echo "${#digests[@]} digests:"
  for answer in "${!digests[@]}"; do echo "  $answer: ${digests[$answer]}"; done
  exit 1
fi
((failed)) || echo "All agree: ${!digests[*]}"
exit "$failed"
