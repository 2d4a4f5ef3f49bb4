#!/bin/bash
# The whole way of a scenario under a real X server: a new scenario on a map, people and goals drawn
# with the mouse, goals assigned, behaviours chosen, the file saved and closed, opened again, edited,
# saved, and the program left. The files are those of tst_Workflow, byte for byte.
#   workflow_xdotool.sh PROGRAM DATA_FOLDER
program=$1
data=$2
# shellcheck source=xdotool_hands.sh
. "$(dirname "$0")/xdotool_hands.sh"

made=$work/scenarios/hall_agents_demo.yaml
mkdir -p "$work/maps" "$work/scenarios"
cp "$data"/hall.yaml "$data"/hall.pgm "$work/maps/" || fail "no map"

new_on_map() {
  focus "$main"
  press ctrl+shift+n
  answer 'New scenario from a map' "$work/maps/hall.yaml"
  sleep 1
}

start

# Where the map lies on the screen: two goals at known pixels, and where the file says they are.
new_on_map
press g
click 480 560
click 720 260
press ctrl+s
answer 'Save the scenario' "$work/scenarios/places.yaml"
wait_for_file "$work/scenarios/places.yaml"
places=$(awk '/global_goals:/ {on = 1} /agents:/ {on = 0} on && /^        [xy]:/ {print $2}' \
  "$work/scenarios/places.yaml" | tr '\n' ' ')
press ctrl+w
# "x y" of the screen for a point of the map [m]
at() {
  echo "$places $1 $2" | awk '{printf "%d %d", 480 + ($5 - $1) * (720 - 480) / ($3 - $1) + 0.5,
                                    560 + ($6 - $2) * (260 - 560) / ($4 - $2) + 0.5}'
}
click_map() {
  # shellcheck disable=SC2046
  click $(at "$1" "$2")
}
drag_map() {
  # shellcheck disable=SC2046
  drag $(at "$1" "$2") $(at "$3" "$4")
}
# On half metres, with Ctrl held.
on_grid() {
  xdotool keydown ctrl
  sleep 0.1
  "$@"
  xdotool keyup ctrl
  sleep 0.1
}

new_on_map
clicks=0
press p
on_grid drag_map 2 2 2 4
on_grid drag_map 5 2 7 2
on_grid drag_map 8 6 6 6
press g
for place in "2 6.5" "5 6.5" "8 4" "5 4" "8 1"; do
  # shellcheck disable=SC2086
  on_grid click_map $place
done

press ctrl+g
assign=$(find_window 'Assign goals') || fail "no dialog for goals"
focus "$assign"
press Down  # all people without goals are chosen at first: choose the first one alone
press Home
press Tab
press End  # the first goal may be the current one already without being chosen
press Home
press Return
press Down
press Return
press shift+Tab
press Down
press Tab
press Home
press Down
press Down
press Return
press Down
press Return
press Down
press Return
press shift+Tab
press Down
press Tab
press End
press Return
press Home
press Return
press Tab
press Return
sleep 0.5
focus "$main"

# The entry of the menu of behaviours with that number, for the person there.
make_behave() {
  click_map "$1" "$2"
  press alt+b
  press Home
  for _ in $(seq 2 "$3"); do
    press Down
  done
  press Return
}
press v
make_behave 5 2 5
make_behave 8 6 4
press ctrl+s
answer 'Save the scenario' "$made"
wait_for_file "$made"
expect_file "$made" "$data/first.yaml"
[ "$(ls "$work"/behavior_trees/hall_agents_demo__agent_*_bt.xml | wc -l)" = 3 ] ||
  fail "not three trees"

press ctrl+w
press ctrl+o
answer 'Open a scenario or a map' "$made"
sleep 1
press v
on_grid drag_map 8 4.15 8 3.15
click_map 5 4.15
press Delete
press ctrl+s
expect_file "$made" "$data/second.yaml"

leave
echo "drawn, assigned, saved, opened again, edited, saved and left: $clicks clicks and drags"
