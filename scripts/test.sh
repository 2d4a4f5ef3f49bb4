#!/usr/bin/env bash
# Checks the format, builds (dev) and runs every test. Usage: scripts/test.sh [--all]
# --all builds with the Python module (full) and adds long tests, fuzzing, the sanitizers, a long monkey
# test of the window, clang-tidy and the benchmarks.
# --monkey MINUTES [SEED] runs only the monkey test, for that time, from this seed on.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

fuzz_seconds=60

usage() {
  say "usage: scripts/test.sh [--all | --monkey MINUTES [SEED]]"
  exit 64
}

check_format() {
  say "checking the format"
  (
    cd "$root"
    find app editor sim2d bt metrics maps tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
      xargs -0 -r -n 20 -P "$jobs" clang-format-14 --dry-run --Werror
  ) || fail "format differs; mend it with clang-format-14 -i FILE"
}

# What tests write lies in memory where there is room: they sync all they write, and a disk takes two
# thirds of their time. A link stands in the place of the folder until the shell ends.
memory_of() {
  printf '/dev/shm/hunavsim-tests-%s-%s' "$(id -u)" "$(cksum <<<"$build/$1" | cut -d ' ' -f 1)"
}

# has_memory: 8 GB of it for files that may be programs, and 12 in all.
has_memory() {
  local room available
  room=$(df --output=avail -k /dev/shm 2>/dev/null | tail -n 1) || return 1
  available=$(awk '/^MemAvailable/ { print $2 }' /proc/meminfo)
  [ "${room:-0}" -ge $((8 << 20)) ] && [ "${available:-0}" -ge $((12 << 20)) ] &&
    ! grep -q '^[^ ]* /dev/shm [^ ]* [^ ]*noexec' /proc/mounts
}

# free_memory PRESET
free_memory() {
  local folder=$build/$1/test-output/tmp
  rm -rf "$(memory_of "$1")"
  if [ -L "$folder" ]; then
    rm "$folder"
    mkdir -p "$folder"
  fi
}

keep_in_memory() {
  free_memory "$1"
  if has_memory && mkdir -m 700 "$(memory_of "$1")"; then
    rm -rf "$build/$1/test-output/tmp"
    mkdir -p "$build/$1/test-output"
    ln -s "$(memory_of "$1")" "$build/$1/test-output/tmp"
    in_memory=$1
    trap 'free_memory "$in_memory"' EXIT
  fi
}

# After a run that was killed.
mend_links() {
  local folder
  for folder in "$build"/*/test-output/tmp; do
    if [ -L "$folder" ]; then
      folder=${folder%/test-output/tmp}
      free_memory "${folder##*/}"
    fi
  done
}

# run_tests PRESET [CTEST OPTIONS…]: one more at a time than there are processors, as tests wait for
# programs and clocks for a quarter of their time.
run_tests() {
  local preset=$1
  shift
  local status=0
  say "testing $preset"
  keep_in_memory "$preset"
  (cd "$root" && "${launcher[@]}" ctest --preset "$preset" --parallel $((jobs + 1)) --no-tests=error \
    --output-log "$logs/tests-$preset.log" "$@") || status=$?
  show_slowest "$logs/tests-$preset.log"
  return "$status"
}

# show_slowest LOG
show_slowest() {
  say "the slowest 30 tests [s]:"
  grep -oE '[[:alnum:]_.]+ \.+ *[*A-Za-z]+ +[0-9.]+ sec' "$1" | awk '{ print $(NF - 1), $1 }' |
    sort -rn | awk 'NR <= 30' >&2
}

# Every program of tests/fuzz, together for fuzz_seconds, with new inputs at every run, from its seeds
# and what it found before.
fuzz() {
  local programs=() program corpus
  build_preset fuzz fuzzers
  without_randomisation  # addresses steer the fuzzer
  mapfile -t programs < <(find "$build/fuzz/fuzzers" -maxdepth 1 -type f -name 'fuzz_*' -executable)
  [ "${#programs[@]}" -gt 0 ] || fail "tests/fuzz holds no fuzz_*.cpp"
  for program in "${programs[@]}"; do
    corpus=$build/fuzz/corpus/${program##*/}
    mkdir -p "$corpus"
    local seeds=$root/tests/fuzz/corpus/${program##*/}
    local folders=("$corpus")
    if [ -d "$seeds" ]; then
      folders+=("$seeds")
    fi
    say "fuzzing with ${program##*/}"
    logged "$logs/${program##*/}.log" "${launcher[@]}" "$program" -rss_limit_mb=4096 -timeout=10 \
      -reload=0 -max_total_time=$((fuzz_seconds / ${#programs[@]} + 1)) \
      -artifact_prefix="$build/fuzz/" "${folders[@]}"
  done
}

# Sets the launcher. ThreadSanitizer of gcc 12 fails under the address randomisation of newer kernels.
without_randomisation() {
  if setarch "$(uname -m)" -R true 2>/dev/null; then
    launcher=(setarch "$(uname -m)" -R)
  fi
}

# Runs the random part of tst_Monkey on the window of the asan build under a real X server, with two
# halves of the seeds in parallel: one with events of Qt, one with events of the X server. It has its
# own home and drops root, so the server does not check keys (-ac). It does not load Mesa, which leaks
# and is unloaded when leaks are reported. Freed memory is overwritten, so that Qt, which is not built
# with asan, fails on it. Sizes of deletes are not checked, as in the preset: Debian's Fast DDS deletes
# a writer by its base, and clang 14 passes no size in the deletes of our own code. The diaries contain
# the last events.
play_monkey() {
  local play half=10 plays=() passed=yes
  say "pressing everything (asan)"
  logged "$logs/monkey-1.log" play_seeds 1 "$half" qt &
  plays+=($!)
  logged "$logs/monkey-$((1 + half)).log" play_seeds $((1 + half)) "$half" x11 &
  plays+=($!)
  for play in "${plays[@]}"; do
    wait "$play" || passed=no
  done
  [ "$passed" = yes ] || exit 1
}

# play_seeds FIRST COUNT HANDS
play_seeds() {
  local diary=$logs/monkey-diary-$1.log
  : >"$diary"
  chmod 666 "$diary"
  xvfb-run -a -s "-ac -nolisten tcp -screen 0 1600x1200x24" \
    env QT_QPA_PLATFORM=xcb QT_XCB_GL_INTEGRATION=none QTEST_FUNCTION_TIMEOUT=3600000 \
    UBSAN_OPTIONS=print_stacktrace=1 HUNAV_MONKEY_DIARY="$diary" \
    ASAN_OPTIONS=new_delete_type_mismatch=0:max_free_fill_size=1000000:free_fill_byte=221 \
    LSAN_OPTIONS="suppressions=$root/tests/lsan.supp:print_suppressions=0" \
    HUNAV_MONKEY_FIRST="$1" HUNAV_MONKEY_SEEDS="$2" HUNAV_MONKEY_EVENTS=3000 HUNAV_MONKEY_HANDS="$3" \
    "$build/asan/tests/tst_Monkey"
}

# play_some FIRST STEP END: seeds FIRST, FIRST + STEP, … until the time END [s], each in its own
# process. Failed seeds keep their logs, and the others continue.
play_some() {
  local seed=$1 hands failed=0
  while [ "$(date +%s)" -lt "$3" ]; do
    hands=$([ $((seed / 2 % 2)) -eq 0 ] && echo qt || echo x11)  # every other seed opens all panels
    if play_seeds "$seed" 1 "$hands" >"$logs/monkey-$seed.log" 2>&1; then
      rm -f "$logs/monkey-$seed.log" "$logs/monkey-diary-$seed.log"
    else
      say "seed $seed ($hands): $logs/monkey-$seed.log"
      failed=1
    fi
    seed=$((seed + $2))
  done
  say "played up to seed $((seed - $2))"
  return "$failed"
}

# play_for MINUTES FIRST: as many in parallel as there are processors.
play_for() {
  local play plays=() passed=yes end
  build_preset asan tst_Monkey hunavsim
  end=$(($(date +%s) + 60 * $1))
  say "pressing everything for $1 minutes (asan)"
  for ((play = 0; play < jobs; ++play)); do
    play_some $(($2 + play)) "$jobs" "$end" &
    plays+=($!)
  done
  for play in "${plays[@]}"; do
    wait "$play" || passed=no
  done
  [ "$passed" = yes ] || fail "the monkey test failed"
}

# What tidy.sh hands to clang-tidy.
build_own_code() {
  local plugin=$build/OwnCode.so
  if [ ! "$plugin" -nt "$root/scripts/OwnCode.cpp" ]; then
    logged "$logs/own-code.log" g++ -std=c++17 -O1 -fno-rtti -fPIC -shared \
      -isystem /usr/lib/llvm-14/include "$root/scripts/OwnCode.cpp" -o "$plugin"
  fi
}

check_sources_and_memory() {
  build_own_code
  build_preset asan  # clang-tidy looks at each source
  run_tests asan
}

check_threads() {
  without_randomisation  # the build runs a program of its own as well
  build_preset tsan core_tests thread_tests
  run_tests tsan -L '^(core|threads)$'
}

# They have to run; `ctest --preset bench -C Bench -L bench` measures them as released.
run_benchmarks() {
  run_tests full -C Bench -L '^bench$' --parallel 1
  say "results of the benchmarks: $build/full/bench/*.csv"
}

# stage COMMAND: in a shell of its own; after one that fails the others go on, and the end tells.
failed=()
stage() {
  local status
  set +e
  (
    set -e
    "$@"
  )
  status=$?
  set -e
  [ "$status" -eq 0 ] || failed+=("$*")
}

is_number() {
  [[ $1 =~ ^[1-9][0-9]*$ ]]
}

all=no
minutes=
case $#,${1-} in
  0,) ;;
  1,--all) all=yes && export HUNAV_ALL_TESTS=1 ;;
  [23],--monkey)
    minutes=$2 seed=${3:-1}
    if ! is_number "$minutes" || ! is_number "$seed"; then
      usage
    fi
    ;;
  *) usage ;;
esac

lock_build
mend_links
need_packages "${packages_to_run[@]}" "${packages_to_test[@]}"
want_packages "${packages_to_read[@]}"
want_packages "${packages_to_learn[@]}"
[ "$all" = no ] || need_packages "${packages_to_compare[@]}"
if [ -n "$minutes" ]; then
  need_packages "${packages_to_check[@]}"
  keep_home_clean
  play_for "$minutes" "$seed"
  exit
fi
need_peers
check_format
keep_home_clean
if [ "$all" = no ]; then
  build_preset dev
  run_tests dev
  exit
fi

need_packages "${packages_to_python[@]}" "${packages_to_fuzz[@]}" "${packages_to_check[@]}"
build_preset full
stage run_tests full
unset HUNAV_ALL_TESTS  # under a sanitizer the long ones would take hours
for command in fuzz check_sources_and_memory play_monkey check_threads run_benchmarks; do
  stage "$command"
done
[ "${#failed[@]}" -eq 0 ] || fail "failed: ${failed[*]}"
