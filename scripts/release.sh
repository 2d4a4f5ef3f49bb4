#!/usr/bin/env bash
# Builds and checks a release. Usage: scripts/release.sh [--no-tests]
# Tests, builds (as released, with the Python module) with manual and packages, checks metadata and version,
# and writes into build/packages: the Debian packages, their checksums and the release notes from CHANGELOG.md.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/common.sh"

packages=$build/packages
preset=python  # release build of program and Python module

version_of_project() {
  sed -n 's/^project(hunavsim VERSION \([0-9.]*\) .*/\1/p' "$root/CMakeLists.txt"
}

# The section of this version, without its heading.
release_notes() {
  awk -v heading="## $1 " 'index($0, heading) == 1 { found = 1; next }
                           /^## / { found = 0 } found' "$root/CHANGELOG.md"
}

# Program, changelog and citation have the version of CMakeLists.txt.
check_version() {
  local version=$1
  "$build/$preset/hunavsim" --version | grep -qF "hunavsim $version " ||
    fail "hunavsim --version is not $version"
  grep -m 1 '^## ' "$root/CHANGELOG.md" | grep -qE "^## $version \([0-9]{4}-[0-9]{2}-[0-9]{2}\)$" ||
    fail "CHANGELOG.md does not begin with a section '## $version (YYYY-MM-DD)'"
  grep -qxF "version: $version" "$root/CITATION.cff" || fail "CITATION.cff is not of version $version"
  [ -n "$(release_notes "$version")" ] || fail "CHANGELOG.md has no notes for $version"
}

check_metadata() {
  local file=$build/$preset/desktop/io.github.hunavsim.desktop.metainfo.xml
  if command -v appstreamcli >/dev/null; then
    logged "$logs/appstream.log" appstreamcli validate --no-net "$file"
  fi
  if command -v desktop-file-validate >/dev/null; then
    logged "$logs/desktop.log" desktop-file-validate "$root/resources/desktop/hunavsim.desktop"
  fi
}

# Equal sources give equal packages: times are those of the last commit.
make_packages() {
  local time
  time=$(git -C "$root" log -1 --format=%ct 2>/dev/null || true)
  rm -rf "$packages"
  mkdir -p "$packages"
  say "packing"
  logged "$logs/cpack.log" env SOURCE_DATE_EPOCH="${time:-0}" \
    cpack --config "$build/$preset/CPackConfig.cmake" -B "$packages"
  rm -rf "$packages/_CPack_Packages"
}

# The demo runs from the unpacked packages, and the Python module finds the data of the other one.
try_packages() {
  local folder=$build/package-trial package
  rm -rf "$folder"
  for package in "$packages"/*.deb; do
    dpkg-deb -x "$package" "$folder"
  done
  logged "$logs/package.log" "$folder/usr/bin/hunavsim" run corner_cafe_agents --duration 5 --quiet
  logged "$logs/package-python.log" env PYTHONPATH="$folder/usr/lib/python3/dist-packages" \
    /usr/bin/python3 -B -c 'import hunavsim; hunavsim.Scenario("corner_cafe_agents")'
  logged "$logs/package-onnx.log" "$folder/usr/bin/hunavsim" run crossing_agents --duration 5 --quiet --planner onnx \
    --set "robot1.planner_parameters.file=$folder/usr/share/hunavsim/resources/policies/crossing_policy.onnx"
  [ -f "$folder/usr/share/hunavsim/manual/index.html" ] || fail "the package has no manual"
  rm -rf "$folder"
}

tests=yes
case ${1-} in
  "") ;;
  --no-tests) tests=no ;;
  *)
    say "usage: scripts/release.sh [--no-tests]"
    exit 64
    ;;
esac
if [ "$tests" = yes ]; then
  "$root/scripts/test.sh"
fi
lock_build
need_packages "${packages_to_run[@]}" "${packages_to_release[@]}" "${packages_to_python[@]}"
build_preset "$preset"
version=$(version_of_project)
check_version "$version"
check_metadata
make_packages
try_packages
release_notes "$version" >"$packages/release-notes.md"
(cd "$packages" && sha256sum ./*.deb >SHA256SUMS)
say "ready: $packages"
ls "$packages"
