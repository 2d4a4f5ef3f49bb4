#!/bin/bash
# atspi_dump.sh PROGRAM SCENARIO: starts the window on a private X server and D-Bus session, reads its
# tree through AT-SPI with pyatspi and lists the controls without a name. Exit code 77: not installed.
set -u
program=$1 scenario=$2
python=/usr/bin/python3  # pyatspi belongs to the system's interpreter
for tool in Xvfb dbus-run-session $python; do
  command -v $tool >/dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
$python -c 'import pyatspi' 2>/dev/null || { echo "skipped: python3-pyatspi is not installed"; exit 77; }
[[ -x $program ]] || { echo "skipped: the program is not built"; exit 77; }
launcher=$(ls /usr/libexec/at-spi-bus-launcher /usr/lib/at-spi2-core/at-spi-bus-launcher 2>/dev/null | head -1)
[[ -n $launcher ]] || { echo "skipped: at-spi2-core is not installed"; exit 77; }
home=$(mktemp -d)
export HOME=$home XDG_RUNTIME_DIR=$home XDG_CONFIG_HOME=$home XDG_CACHE_HOME=$home XDG_DATA_HOME=$home
chmod 700 "$home"
exec 3> >(cat >"$home/display")
Xvfb -displayfd 3 -ac -noreset -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1 &
server=$!
trap 'kill $server 2>/dev/null; rm -rf "$home"' EXIT
for ((i = 0; i < 100; ++i)); do [[ -s $home/display ]] && break; sleep 0.1; done
export DISPLAY=:$(tr -d '\n' <"$home/display")
[[ $DISPLAY == : ]] && { echo "skipped: Xvfb does not start"; exit 77; }
export QT_QPA_PLATFORM=xcb QT_LINUX_ACCESSIBILITY_ALWAYS_ON=1 QT_ACCESSIBILITY=1 NO_AT_BRIDGE=0
dbus-run-session -- bash -c '
  "$1" --launch-immediately &
  bus=$!
  sleep 1
  "$2" "$3" --theme light &
  window=$!
  "$5" "$4"
  code=$?
  kill $window $bus 2>/dev/null
  exit $code' _ "$launcher" "$program" "$scenario" "$(dirname "$0")/atspi_dump.py" $python
