#!/bin/bash
# The whole way of a scenario under a real X server: a map is opened, people and goals are drawn
# with the mouse, goals assigned, a behaviour chosen, the file saved, and the program left.
#   workflow_xdotool.sh PROGRAM DATA_FOLDER
# 77 = skipped: xdotool or Xvfb is not there.
set -u
program=$1
data=$2

for tool in xdotool Xvfb; do
  if ! command -v "$tool" >/dev/null; then
    echo "skipped: $tool is not installed"
    exit 77
  fi
done

work=$(mktemp -d)
server=
window=
stop() {
  [ -n "$window" ] && kill "$window" 2>/dev/null
  [ -n "$server" ] && kill "$server" 2>/dev/null
  wait 2>/dev/null
  rm -rf "$work"
}
trap stop EXIT

fail() {
  echo "FAIL: $1"
  [ -f "$work/program.log" ] && cat "$work/program.log"
  [ -f "$work/scenarios/made.yaml" ] && cat "$work/scenarios/made.yaml"
  exit 1
}

mkdir -p "$work/maps" "$work/scenarios" "$work/config"
cp "$data"/hall.yaml "$data"/hall.pgm "$work/maps/" || fail "no map"

# A free display is chosen by the server itself and told on descriptor 3.
exec 3>"$work/display"
Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp >"$work/server.log" 2>&1 &
server=$!
for _ in $(seq 100); do
  [ -s "$work/display" ] && break
  sleep 0.1
done
if [ ! -s "$work/display" ]; then
  echo "skipped: Xvfb does not start here"
  exit 77
fi
DISPLAY=:$(head -1 "$work/display")
export DISPLAY
# Plugins of the X server's side are unloaded before a sanitizer looks for leaks: theirs have no name
# to leave them out by.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"
export QT_QPA_PLATFORM=xcb QT_QPA_PLATFORMTHEME= XDG_CONFIG_HOME=$work/config LC_ALL=C.UTF-8

"$program" "$work/maps/hall.yaml" >"$work/program.log" 2>&1 &
window=$!

# The id of the visible window with that title; waits for it.
find_window() {
  local id
  for _ in $(seq 150); do
    kill -0 "$window" 2>/dev/null || fail "the program has ended"
    id=$(xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -1)
    if [ -n "$id" ]; then
      echo "$id"
      return 0
    fi
    sleep 0.2
  done
  return 1
}

main=$(find_window 'HuNavSim Desktop') || fail "no window"
xdotool windowmove "$main" 0 0 windowsize "$main" 1280 800
sleep 2
# There is no window manager that gives the focus.
xdotool windowfocus --sync "$main"

press() { xdotool key --clearmodifiers "$@"; sleep 0.4; }
click() { xdotool mousemove "$1" "$2" click 1; sleep 0.4; }
drag() {
  xdotool mousemove "$1" "$2" mousedown 1
  sleep 0.1
  xdotool mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2)) mousemove "$3" "$4"
  sleep 0.1
  xdotool mouseup 1
  sleep 0.4
}

# The canvas lies between the docks; these places are on the free ground of the hall.
click 600 350
press p
drag 500 250 500 200
drag 600 450 660 450
drag 720 300 680 300
press g
for place in "480 330" "560 230" "640 380" "700 430" "560 500"; do
  # shellcheck disable=SC2086
  click $place
done
press ctrl+g
assign=$(find_window 'Assign goals') || fail "no dialog for goals"
xdotool windowfocus --sync "$assign"
sleep 0.5
press Home
press shift+End
press Tab
press Home
press shift+End
press Return
press Tab
press Return
sleep 0.5
xdotool windowfocus --sync "$main"
press v
click 500 250
press alt+b
press Down
press Down
press Return
press ctrl+s
save=$(find_window 'Save the scenario') || fail "no dialog for saving"
xdotool windowfocus --sync "$save"
sleep 0.5
xdotool key --clearmodifiers ctrl+a
xdotool type --delay 20 "$work/scenarios/made.yaml"
press Return
for _ in $(seq 50); do
  [ -s "$work/scenarios/made.yaml" ] && break
  sleep 0.2
done
sleep 0.5

made=$work/scenarios/made.yaml
[ -s "$made" ] || fail "nothing was saved"
people=$(grep -c '^      id: \|^      init_pose:' "$made")
[ "$people" = 6 ] || fail "not three people"
goals=$(sed -n '/global_goals:/,/agents:/p' "$made" | grep -c '^        x:')
[ "$goals" = 5 ] || fail "$goals goals instead of 5"
assigned=$(grep -c '^        - [1-5]$' "$made")
[ "$assigned" = 15 ] || fail "$assigned goals assigned instead of 15"
[ "$(grep -c 'type: Regular' "$made")" = 2 ] || fail "no behaviour was chosen"
[ "$(ls "$work"/behavior_trees/made__agent_*_bt.xml | wc -l)" = 3 ] || fail "not three trees"

xdotool windowfocus --sync "$main"
press ctrl+q
for _ in $(seq 50); do
  kill -0 "$window" 2>/dev/null || break
  sleep 0.2
done
kill -0 "$window" 2>/dev/null && fail "the program does not end"
wait "$window" || fail "the program ended with an error"
window=
echo "drawn, assigned, saved and left"
