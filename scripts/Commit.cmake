# Writes what app::programCommit() says: cmake -DSOURCE=FOLDER -DOUTPUT=FILE -P Commit.cmake. The commit;
# where what the program is made of differs from it, with "-dirty-" and a hash of the difference; so
# two programs of one commit are told apart. FILE keeps its time where nothing changes.
cmake_minimum_required(VERSION 3.22)
set(parts app bt editor metrics resources sim2d CMakeLists.txt CMakePresets.json scripts/*.cmake
    :!*.md)
set(ENV{GIT_OPTIONAL_LOCKS} 0)

# git(<output> <words…>): empty where it fails.
function(git output)
  execute_process(COMMAND git ${ARGN} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE status
                  OUTPUT_VARIABLE text OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(text "")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

set(commit "")
if(EXISTS ${SOURCE}/.git)  # not that of a folder around an unpacked archive
  git(commit rev-parse --short=12 HEAD)
endif()
if(commit)
  git(difference diff HEAD --binary --no-ext-diff --no-textconv -- ${parts})
  git(added ls-files --others --exclude-standard -- ${parts})
  string(REPLACE "\n" ";" added "${added}")
  foreach(file IN LISTS added)
    if(EXISTS "${SOURCE}/${file}")
      file(SHA256 "${SOURCE}/${file}" hash)
      string(APPEND difference "\n${file} ${hash}")
    endif()
  endforeach()
  if(NOT difference STREQUAL "")
    string(SHA256 hash "${difference}")
    string(SUBSTRING ${hash} 0 8 hash)
    string(APPEND commit "-dirty-${hash}")
  endif()
else()
  set(commit unknown)
endif()

set(text "// Written by scripts/Commit.cmake.
#include \"app/run/DataPaths.h\"

std::string app::programCommit() {
  return \"${commit}\";
}
")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "@text@" @ONLY)
