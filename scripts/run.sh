#!/usr/bin/env bash
# Installs what is missing, builds and starts hunavsim. Usage: scripts/run.sh [ARGS…]
# ARGS go to hunavsim as they are. Without any: the editor on the demo scenario or, where there is
# no display, a headless run of it.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

demo_scenario=$root/maps/corner_cafe/corner_cafe_agents.yaml
demo_output=$build/demo-run

packages=("${packages_to_run[@]}")
if [ -z "${DISPLAY:-}" ] && [ -n "${WAYLAND_DISPLAY:-}" ]; then
  packages+=(qtwayland5)
fi

lock_build
need_packages "${packages[@]}"
want_packages "${packages_to_read[@]}"
want_packages "${packages_to_learn[@]}"
build_preset release
unlock_build
keep_home_clean
program=$build/release/hunavsim

if [ $# -gt 0 ]; then
  exec "$program" "$@"
fi
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$program" "$demo_scenario"
fi
"$program" run "$demo_scenario" -o "$demo_output"
"$program" render "$demo_output" -o "$demo_output/run.png"
printf '\nNo display here, so the demo ran without a window.\n'
printf 'Files of the run: %s\n' "$demo_output"
printf 'Picture:          %s\n' "$demo_output/run.png"
