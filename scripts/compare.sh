#!/usr/bin/env bash
# Compares what two builds of the program write. Usage: scripts/compare.sh OLD NEW [SCENARIO…]
# For every shipped scenario (or those given): the files of a run with a bag, its pictures, video data
# and vectors, exports for every simulator, the check; then a batch with its report, and all lists.
# Versions, commits and measured times are left out. Prints each file that differs; returns 1 if any
# does.
set -euo pipefail
[ $# -ge 2 ] || {
  printf 'usage: scripts/compare.sh OLD NEW [SCENARIO…]\n' >&2
  exit 64
}
old=$(readlink -f "$1")
new=$(readlink -f "$2")
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export QT_QPA_PLATFORM=offscreen

scenarios=("$@")
if [ ${#scenarios[@]} -eq 0 ]; then
  mapfile -t scenarios < <("$new" list scenarios --format json | sed -n 's/.*"path": "\(.*\)".*/\1/p')
fi

# record SIDE PROGRAM: everything into $work/SIDE, from the same folder names.
record() {
  local program=$2 scenario name target what
  ln -sfn "$work/$1" "$work/now"
  mkdir -p "$work/$1"
  cd "$work/now"
  for scenario in "${scenarios[@]}"; do
    name=$(basename "${scenario%.*}")
    "$program" check "$scenario" >"$name.check" 2>&1 || true
    "$program" run "$scenario" --seed 3 --duration 12 --record mcap -q -o "$name.run" \
      >"$name.out" 2>&1 || true
    for what in svg png pdf csv json ndjson html; do
      "$program" render "$name.run" -o "$name.$what" -q >>"$name.out" 2>&1 || true
    done
    for target in gazebo-classic gazebo-fortress isaac webots native; do
      "$program" convert "$scenario" --target "$target" -o "$name.$target" -q \
        >"$name.$target.out" 2>&1 || true
    done
  done
  printf 'hunavsim_experiment: 1\nscenarios: [%s]\nseeds: 2\nduration: 4.0\nrecord: all\n' \
    "${scenarios[0]}" >study.yaml
  "$program" batch study.yaml -o study -q --jobs 2 >study.out 2>&1 || true
  "$program" report study -q >report.out 2>&1 || true
  for what in keys metrics models nodes planners robots scenarios; do
    "$program" list "$what" --format json >"list.$what.json" 2>&1 || true
    "$program" list "$what" >"list.$what.txt" 2>&1 || true
  done
  cd /
}

# Version, commit and times of a JSON file; the program's path.
neutral() {
  sed -E -e '/"(version|commit|wall_seconds|real_time_factor|planning_time[a-z_]*)":/d' \
    -e "s|$old|PROGRAM|g; s|$new|PROGRAM|g" -e '/"sha256": /d' "$1"
}

record old "$old"
record new "$new"
differing=0
while IFS= read -r file; do
  if [ ! -e "$work/new/$file" ]; then
    printf 'only in old: %s\n' "$file"
    differing=1
  elif ! cmp -s "$work/old/$file" "$work/new/$file" &&
    ! cmp -s <(neutral "$work/old/$file") <(neutral "$work/new/$file"); then
    printf 'differs: %s\n' "$file"
    differing=1
  fi
done < <(cd "$work/old" && find . -type f -printf '%P\n' | sort)
while IFS= read -r file; do
  [ -e "$work/old/$file" ] || {
    printf 'only in new: %s\n' "$file"
    differing=1
  }
done < <(cd "$work/new" && find . -type f -printf '%P\n' | sort)
[ -z "${HUNAV_KEEP:-}" ] || cp -r "$work" "$HUNAV_KEEP"
exit $differing
