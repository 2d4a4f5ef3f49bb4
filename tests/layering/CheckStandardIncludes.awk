# Precompiled headers hide a forgotten #include. Reads sources named from the root, in one run, and
# tells each file that uses a name of the standard library whose header neither it nor any header of
# ours that it reaches includes.
#   find app sim2d -name '*.h' -o -name '*.cpp' | xargs awk -f CheckStandardIncludes.awk
BEGIN {
  names["vector"] = "vector"
  names["string"] = "string|to_string"
  names["string_view"] = "string_view"
  names["optional"] = "optional|nullopt"
  names["memory"] = "unique_ptr|shared_ptr|weak_ptr|make_unique|make_shared"
  names["map"] = "map|multimap"
  names["functional"] = "function|invoke|not_fn|ref"
  names["algorithm"] = "sort|stable_sort|min|max|clamp|find|find_if|any_of|all_of|none_of|copy|" \
      "count_if|min_element|max_element|transform|remove_if|lower_bound|upper_bound|reverse|fill|" \
      "replace|unique|rotate|equal|partition|stable_partition|nth_element|merge|binary_search"
  names["cmath"] = "sqrt|fabs|isfinite|isnan|isinf|llround|lround|round|floor|ceil|hypot|pow|" \
      "nan|fmod|exp|log|sin|cos|tan|atan2|acos"
  names["utility"] = "move|pair|forward|exchange|swap"
}
{
  line = $0
  sub(/\/\/.*/, "", line)
}
line ~ /^#include "/ {
  split(line, part, "\"")
  ours[FILENAME] = ours[FILENAME] " " part[2]
  next
}
line ~ /^#include </ {
  gsub(/^#include <|>.*/, "", line)
  holds[FILENAME, line] = 1
  next
}
line ~ /std::/ {
  for (header in names) {
    if (!((FILENAME, header) in used) && line ~ ("std::(" names[header] ")([^A-Za-z0-9_]|$)")) {
      used[FILENAME, header] = FNR
      files[FILENAME] = 1
    }
  }
}
# Whether `file` or what it includes of ours includes <header>; marks files as visited in `seen`.
function reaches(file, header, seen,    list, count, i) {
  if ((file, header) in holds) {
    return 1
  }
  seen[file] = 1
  count = split(ours[file], list, " ")
  for (i = 1; i <= count; ++i) {
    if (!(list[i] in seen) && reaches(list[i], header, seen)) {
      return 1
    }
  }
  return 0
}
END {
  for (file in files) {
    for (header in names) {
      split("", seen)
      if (((file, header) in used) && !reaches(file, header, seen)) {
        print file ":" used[file, header] ": needs #include <" header ">"
        failed = 1
      }
    }
  }
  exit failed
}
