#!/usr/bin/env bash
# clang-tidy for CMake (CMAKE_CXX_CLANG_TIDY): scripts/tidy.sh TIDY [OPTIONS] SOURCE -- COMPILER …
# A source that has passed before, with all that it includes and the same checks, is not looked at
# again: what has passed is kept in the cache of the compiler.
set -euo pipefail

root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd -P)
tidy=("$1")
if [ -e "$root/build/OwnCode.so" ]; then
  tidy+=(--load="$root/build/OwnCode.so")
fi
case $* in
  */unity_*_cxx.cxx*)  # it includes sources, and stands in a folder with other checks
    checks=-bugprone-suspicious-include
    case $* in
      */tests/unity_*) checks+=,$(sed -n "s/^Checks: '\(.*\)'/\1/p" "$root/tests/.clang-tidy") ;;
    esac
    tidy+=(--config-file="$root/.clang-tidy" --checks="$checks")
    words=()
    for word in "$@"; do
      case $word in
        */unity_*_cxx.cxx)  # under this name alone the analyzer looks into what is included
          unit=${word%/*}/UnifiedSource${word##*/unity}
          cp "$word" "$unit"
          word=$unit
          ;;
      esac
      words+=("$word")
    done
    set -- "${words[@]}"
    ;;
esac
words=("${tidy[@]}" "${@:2}")
passed=${CCACHE_DIR:-$root/build/ccache}/tidy

command=()  # of the compiler
while [ "$#" -gt 0 ] && [ "$1" != -- ]; do
  source=$1
  shift
done
shift
while [ "$#" -gt 0 ]; do
  case $1 in
    -o | -MT | -MF) shift ;;
    -c | -MD) ;;
    -Xclang) # a precompiled header hides what it was made of
      if [ "$2" = -include-pch ]; then
        shift 3
      else
        command+=("$1")
      fi
      ;;
    *) command+=("$1") ;;
  esac
  shift
done

# Of the comments, those count that checks read: NOLINT and names of arguments (/*name=*/). The
# others count only as lines.
if sum=$({
  "${tidy[0]}" --version
  cat "$root/scripts/OwnCode.cpp"
  "${tidy[@]}" --dump-config "$source"
  "${command[@]}" -E
  "${command[@]}" -E -C | awk '/NOLINT|\/\* *[A-Za-z_][A-Za-z_0-9]* *= *\*\// { print NR, $0 }'
} 2>/dev/null | sed "s|$root/||g" | sha256sum); then
  sum=${sum%% *}
  if [ -e "$passed/$sum" ]; then
    exit 0
  fi
else
  sum=
fi
"${words[@]}"
if [ -n "$sum" ]; then
  mkdir -p "$passed"
  : >"$passed/$sum"
fi
