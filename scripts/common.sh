# shellcheck shell=bash disable=SC2034
# Shared by run.sh and test.sh (sourced): where things are, packages, one build.
# Everything that is written lies below build/ of the clone, but for what tests write for a while.

unset CDPATH
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd -P)
build=$root/build
logs=$build/logs
jobs=$(nproc 2>/dev/null || echo 2)
export CCACHE_DIR=${CCACHE_DIR:-$build/ccache}
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros}  # as precompiled headers need it
launcher=()  # words before a command, such as setarch
export CCACHE_TEMPDIR=${CCACHE_TEMPDIR:-$build/ccache/tmp}

packages_to_run=(
  g++ cmake ninja-build ccache pkg-config python3
  qtbase5-dev libqt5svg5-dev libqwt-qt5-dev qttools5-dev qttools5-dev-tools
  libbox2d-dev libeigen3-dev libyaml-cpp-dev libtinyxml2-dev libcli11-dev nlohmann-json3-dev
  librandom123-dev libxsimd-dev libboost-dev libssl-dev libhdf5-dev libsqlite3-dev libzstd-dev zlib1g-dev libzmq3-dev libgif-dev libzip-dev
  libfastrtps-dev libfastcdr-dev
  fonts-dejavu-core
)
packages_to_read=(python3-sphinx python3-myst-parser furo)  # for the manual; without them it is left out
packages_to_learn=(libopencv-dnn-dev libopencv-core-dev)  # for the planner onnx; without them it is left out
packages_to_release=("${packages_to_read[@]}" "${packages_to_learn[@]}" appstream desktop-file-utils dpkg-dev file)
packages_to_test=(clang-format-14 mold xvfb xauth xdotool imagemagick locales
  cyclonedds-dev cyclonedds-tools tshark
  dbus at-spi2-core python3-pyatspi)
packages_to_compare=(parallel slurmctld slurmd slurm-client munge chromium ffmpeg)  # what tests run beside us
packages_to_python=(python3-dev pybind11-dev python3-numpy python3-matplotlib)
packages_to_fuzz=(clang-14 libclang-rt-14-dev)
packages_to_check=(clang-14 clang-tidy-14 libclang-14-dev llvm-14)  # llvm-14: lines of a report

say() {
  printf '%s\n' "$*" >&2
}

fail() {
  say "${0##*/}: $*"
  exit 1
}

# Prints those of the given packages that are not installed.
missing_packages() {
  local installed package
  installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "$@" 2>/dev/null || true)
  for package in "$@"; do
    if ! grep -qxF "installed $package" <<<"$installed"; then
      printf '%s\n' "$package"
    fi
  done
}

# Runs apt-get (for `missing` of the caller), through sudo unless we are root; output goes to the log.
run_apt() {
  local become=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "not root and no sudo here. As root: apt-get install ${missing[*]}"
    become=(sudo)
  fi
  "${become[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q "$@" >>"$logs/apt.log" 2>&1
}

# Installs what is missing of the given packages; needs no network when nothing is.
need_packages() {
  if [ -n "${HUNAV_NO_PACKAGES:-}" ]; then
    return 0
  fi
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "This is no Debian or Ubuntu with apt. Please install (names of the Debian packages):"
    say "  $*"
    fail "then set HUNAV_NO_PACKAGES=1 and start again"
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if [ "${#missing[@]}" -eq 0 ]; then
    return 0
  fi
  say "installing ${missing[*]}"
  run_apt update || say "apt-get update failed (see $logs/apt.log), trying with the lists as they are"
  if ! run_apt install -y --no-install-recommends "${missing[@]}"; then
    tail -n 5 "$logs/apt.log" >&2
    fail "could not install: ${missing[*]} (log: $logs/apt.log)"
  fi
}

# Installs packages that the build can do without; a failure is a message.
want_packages() {
  if [ -z "${HUNAV_NO_PACKAGES:-}" ] && command -v apt-get >/dev/null &&
    ! (need_packages "$@"); then
    say "continuing without: $*"
  fi
}

# Readers of others (npm, tests/peers) into build/peers; without npm or the net their tests skip.
need_peers() {
  local folder=$build/peers
  if [ -n "${HUNAV_NO_PACKAGES:-}${HUNAV_PEERS:-}" ] || ! command -v npm >/dev/null ||
    cmp -s "$root/tests/peers/package-lock.json" "$folder/package-lock.json"; then
    return 0
  fi
  say "installing the readers of tests/peers"
  rm -rf "$folder.new"
  mkdir -p "$folder.new"
  cp "$root"/tests/peers/package*.json "$folder.new"
  if npm ci --prefix "$folder.new" --ignore-scripts --no-audit --no-fund --cache "$build/npm" \
    --logs-dir "$logs" >"$logs/npm.log" 2>&1; then
    rm -rf "$folder"
    mv "$folder.new" "$folder"
  else
    say "npm could not install them (log: $logs/npm.log): their tests skip"
  fi
}

# Runs a command with its output in a log; shows the end of it when the command fails.
logged() {
  local log=$1
  shift
  if ! "$@" >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    fail "failed: $* (log: $log)"
  fi
}

# build_preset PRESET [TARGET…]: configures when needed and builds into build/PRESET.
build_preset() {
  local preset=$1
  shift
  local folder=$build/$preset
  local cache=$folder/CMakeCache.txt
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "$folder"  # the clone was moved or copied
  fi
  if [ ! -f "$folder/build.ninja" ] || [ "$root/CMakePresets.json" -nt "$folder/build.ninja" ]; then
    say "configuring $preset"
    # Presets are looked up in the current folder.
    logged "$logs/configure-$preset.log" env -C "$root" cmake --preset "$preset"
  fi
  local command=("${launcher[@]}" cmake --build "$folder" --parallel "$jobs")
  local keep_going=(-- -k 0)  # all that is wrong, not the first only
  if [ $# -gt 0 ]; then
    command+=(--target "$@")
  fi
  if [ -t 2 ]; then
    "${command[@]}" "${keep_going[@]}" >&2 || fail "the build failed"
  else
    say "building $preset"
    logged "$logs/build-$preset.log" "${command[@]}" "${keep_going[@]}"
  fi
}

# Two scripts at once would build into the same folders: the second waits.
lock_build() {
  mkdir -p "$logs" "$CCACHE_DIR" "$CCACHE_TEMPDIR"
  exec 9>"$build/.lock"
  if command -v flock >/dev/null && ! flock -n 9; then
    say "waiting for another build in $build"
    flock 9
  fi
}

unlock_build() {
  exec 9>&-
}

# Settings and caches of the program stay in build/ too, unless the user has a place for them.
keep_home_clean() {
  local home=$build/home
  mkdir -p "$home/config" "$home/cache" "$home/data" "$home/runtime"
  chmod 700 "$home/runtime"
  export XDG_CONFIG_HOME=${XDG_CONFIG_HOME:-$home/config}
  export XDG_CACHE_HOME=${XDG_CACHE_HOME:-$home/cache}
  export XDG_DATA_HOME=${XDG_DATA_HOME:-$home/data}
  export XDG_RUNTIME_DIR=${XDG_RUNTIME_DIR:-$home/runtime}
}
