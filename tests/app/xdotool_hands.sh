# Sourced by the tests that drive the window under a real X server: starts one, and has what a hand
# on mouse and keyboard does. They exit with 77 (skipped) where xdotool or Xvfb is not there.
set -u

for tool in xdotool Xvfb; do
  if ! command -v "$tool" >/dev/null; then
    echo "skipped: $tool is not installed"
    exit 77
  fi
done

work=$(mktemp -d)
server=
programs=
clicks=0
stop() {
  # shellcheck disable=SC2086
  [ -n "$programs" ] && kill $programs 2>/dev/null
  [ -n "$server" ] && kill "$server" 2>/dev/null
  wait 2>/dev/null
  rm -rf "$work"
}
trap stop EXIT

# KEEP_SHOT=file.png keeps a picture of the screen.
fail() {
  echo "FAIL: $1"
  cat "$work"/*.log
  [ -n "${KEEP_SHOT:-}" ] && import -window root "$KEEP_SHOT"
  exit 1
}

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
mkdir -p "$work/config"
# Plugins of the X server's side are unloaded before a sanitizer looks for leaks: theirs have no name
# to leave them out by.
export ASAN_OPTIONS="${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0"
export QT_QPA_PLATFORM=xcb QT_QPA_PLATFORMTHEME= XDG_CONFIG_HOME=$work/config LC_ALL=C.UTF-8

# Starts the program; its process is then $window and its main window $main.
start() {
  "$program" "$@" >>"$work/program.log" 2>&1 &
  window=$!
  programs="$programs $window"
  main=$(find_window 'HuNavSim Desktop') || fail "no window"
  xdotool windowmove "$main" 0 0 windowsize "$main" 1280 800
  sleep 2
}

# The id of the visible window of $window with that title; waits for it.
find_window() {
  local id
  for _ in $(seq 150); do
    kill -0 "$window" 2>/dev/null || fail "the program has ended"
    id=$(xdotool search --all --onlyvisible --pid "$window" --name "$1" 2>/dev/null | tail -1)
    if [ -n "$id" ]; then
      echo "$id"
      return 0
    fi
    sleep 0.2
  done
  return 1
}

# There is no window manager that gives the focus.
focus() { xdotool windowfocus --sync "$1"; sleep 0.3; }
press() { xdotool key --clearmodifiers "$@"; sleep 0.4; }
click() {
  clicks=$((clicks + 1))
  xdotool mousemove "$1" "$2" click 1
  sleep 0.4
}
drag() {
  clicks=$((clicks + 1))
  xdotool mousemove "$1" "$2" mousedown 1
  sleep 0.1
  xdotool mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2)) mousemove "$3" "$4"
  sleep 0.1
  xdotool mouseup 1
  sleep 0.4
}
# The file dialog with that title is told a path.
answer() {
  local dialog
  dialog=$(find_window "$1") || fail "no dialog '$1'"
  focus "$dialog"
  xdotool key --clearmodifiers ctrl+a
  xdotool type --delay 20 "$2"
  press Return
  sleep 0.5
  focus "$main"
}
wait_for_file() {
  for _ in $(seq 50); do
    [ -s "$1" ] && return
    sleep 0.2
  done
  fail "nothing was saved"
}
# Waits until the first file is as the second; the program may still be writing.
expect_file() {
  for _ in $(seq 25); do
    cmp -s "$1" "$2" && return
    sleep 0.2
  done
  diff "$2" "$1"
  fail "$1 is not as expected"
}
# Leaves the program by its key.
leave() {
  focus "$main"
  press ctrl+q
  for _ in $(seq 50); do
    kill -0 "$window" 2>/dev/null || break
    sleep 0.2
  done
  kill -0 "$window" 2>/dev/null && fail "the program does not end"
  wait "$window" || fail "the program ended with an error"
}
