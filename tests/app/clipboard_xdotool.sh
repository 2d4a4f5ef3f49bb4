#!/bin/bash
# Copy and paste between two programs by the clipboard of a real X server.
#   clipboard_xdotool.sh PROGRAM DATA_FOLDER
program=$1
data=$2
# shellcheck source=xdotool_hands.sh
. "$(dirname "$0")/xdotool_hands.sh"

mkdir -p "$work/a" "$work/b"
cp "$data"/hall.yaml "$data"/hall.pgm "$data"/first.yaml "$work/a/" || fail "no scenario"

start "$work/a/first.yaml"
focus "$main"
press ctrl+a
press ctrl+c
first=$window
first_main=$main

start
focus "$main"
press ctrl+n
sleep 1
press ctrl+v
sleep 1
press ctrl+s
answer 'Save the scenario' "$work/b/pasted.yaml"
wait_for_file "$work/b/pasted.yaml"

# All three people with their routes and behaviours, and all five goals: places apart, the same.
lines_of() {
  grep -v '^        [xy]: \|yaml_base_name:\|^    map: \|^    hunavsim' "$1" | sed '/^hunavsim/,$d'
}
lines_of "$work/a/first.yaml" >"$work/a/lines"
lines_of "$work/b/pasted.yaml" >"$work/b/lines"
expect_file "$work/b/lines" "$work/a/lines"
# moved as one: the same step for everybody
steps=$(paste <(grep '^        [xy]: ' "$work/a/first.yaml") \
  <(grep '^        [xy]: ' "$work/b/pasted.yaml") |
  awk '{printf "%s %.3f\n", $1, $4 - $2}' | sort -u | wc -l)
[ "$steps" = 2 ] || fail "not moved as one"
leave
window=$first
main=$first_main
leave
echo "copied in one program, pasted in another"
