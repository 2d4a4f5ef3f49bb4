#!/usr/bin/env bash
# Shows that two programs give the same: every file of every shipped scenario's run (but the
# manifest), its exports, and pictures of the window. Usage: scripts/compare.sh OLD NEW [NAME…]
# OLD and NEW are programs (build/dev/hunavsim of two clones); the scenarios are those beside OLD.
# NAME… limits the scenarios. Exit 1 when anything differs; the first differences are listed.
set -euo pipefail

[ $# -ge 2 ] || { echo "usage: scripts/compare.sh OLD NEW [NAME…]" >&2; exit 64; }
old=$(readlink -f "$1") new=$(readlink -f "$2")
shift 2
maps=$(readlink -f "$(dirname "$old")/../../maps")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$maps" "$work/maps"
export QT_QPA_PLATFORM=offscreen HOME=$work XDG_CONFIG_HOME=$work/config XDG_DATA_HOME=$work/data \
  XDG_CACHE_HOME=$work/cache

mapfile -t scenarios < <(grep -rl '^hunav_loader:' "$work/maps" --include='*.yaml' | sort)
compared=0 differing=0

# both COMMAND…: runs it with each program; `@` in it is the folder of that program.
both() {
  local program side
  for side in old new; do
    program=${!side}
    "$program" "${@//@/$work/$side}" >"$work/$side.log" 2>&1 || echo "exit $?" >>"$work/$side.log"
  done
}

# same WHAT: compares what the two programs left in their folders.
same() {
  local differences
  compared=$((compared + 1))
  rm -f "$work"/{old,new}/manifest.json
  if ! differences=$(diff -rq "$work/old" "$work/new" 2>&1); then
    differing=$((differing + 1))
    printf '%s differs:\n%s\n' "$1" "$(head -n 5 <<<"$differences")"
  fi
  rm -rf "$work/old" "$work/new" "$work"/config
  mkdir -p "$work/old" "$work/new"
}

mkdir -p "$work/old" "$work/new"
for scenario in "${scenarios[@]}"; do
  name=$(basename "$scenario" .yaml)
  if [ $# -gt 0 ] && [[ " $* " != *" $name "* ]]; then
    continue
  fi
  both run "$scenario" -o @
  same "run of $name"
  for target in gazebo-classic gazebo-fortress isaac webots native; do
    both convert "$scenario" -o @ --target "$target"
    same "export of $name to $target"
  done
  for theme in light dark; do
    for at in 0 4; do
      both "$scenario" --screenshot @/window.png --at "$at" --theme "$theme"
      same "picture of $name at $at s, $theme"
    done
  done
done
echo "$compared compared, $differing differ"
[ "$differing" -eq 0 ]
