# Writes what app::programCommit() says: cmake -DSOURCE=FOLDER -DOUTPUT=FILE -P Commit.cmake. The commit;
# where files that the program is made of differ from it, with "-dirty-" and a hash of what they hold;
# so two programs of one commit are told apart. FILE keeps its time where nothing changes.
cmake_minimum_required(VERSION 3.22)
set(parts app bt editor metrics resources sim2d CMakeLists.txt CMakePresets.json scripts/*.cmake
    :!*.md)
set(ENV{GIT_OPTIONAL_LOCKS} 0)

# git(<output> <words…>): a list of the lines; NOTFOUND where git fails, which counts as a difference.
function(git output)
  execute_process(COMMAND git -c core.quotePath=false ${ARGN} WORKING_DIRECTORY ${SOURCE}
                  RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_QUIET
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    set(text NOTFOUND)
  endif()
  string(REPLACE "\n" ";" text "${text}")
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

set(commit NOTFOUND)
if(EXISTS ${SOURCE}/.git)  # not that of a folder around an unpacked archive
  git(commit rev-parse --short=12 HEAD)
endif()
if(commit)
  git(changed diff HEAD --name-only --no-renames --no-ext-diff -- ${parts})
  git(added ls-files --others --exclude-standard -- ${parts})
  set(held "")
  foreach(file IN LISTS changed added)
    set(hash gone)
    if(EXISTS "${SOURCE}/${file}")
      file(SHA256 "${SOURCE}/${file}" hash)
    endif()
    list(APPEND held "${hash} ${file}")
  endforeach()
  if(held)
    list(SORT held)
    string(SHA256 hash "${held}")
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
