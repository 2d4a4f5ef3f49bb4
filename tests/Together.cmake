# Several tests in one file of C++: what a test program takes to build is mostly headers, which are
# then read once. Each test stands in a namespace of its own, with all that it includes before it, and
# its main() becomes a function there. A program of the name of each test is a link to the common one,
# which looks at the name it was started by: ctest and users see no difference.

# Sets <result> to OFF for a source that must be global: it adds to namespaces of others, takes the
# place of functions of the system, defines a macro or includes by condition, or has a main() of its own.
function(can_stand_together source result)
  file(STRINGS ${source} global LIMIT_COUNT 1 REGEX
       "^(namespace [a-zA-Z_0-9:]+ {|Q_DECLARE_METATYPE|template ?<>|extern |#define|#if|int main)|operator new")
  if(global)
    set(${result} OFF PARENT_SCOPE)
  else()
    set(${result} ON PARENT_SCOPE)
  endif()
endfunction()

# Sets <result> to the lines that include what the sources include, the folder of a source looked at first.
function(collect_includes result sources)
  set(all "")
  foreach(source IN LISTS sources)
    get_filename_component(folder ${source} DIRECTORY)
    file(STRINGS ${source} lines REGEX "^#include [<\"]")
    foreach(line IN LISTS lines)
      string(REGEX REPLACE "^#include [<\"](.*)[>\"].*" "\\1" header "${line}")
      if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${header})
        set(line "#include \"tests/${folder}/${header}\"")
      endif()
      if(NOT header MATCHES "\\.moc$")
        list(APPEND all "${line}")
      endif()
    endforeach()
  endforeach()
  list(REMOVE_DUPLICATES all)
  list(JOIN all "\n" all)
  set(${result} "${all}" PARENT_SCOPE)
endfunction()

# add_unit_of_tests(<target> "<sources>" <libraries…>)
function(add_unit_of_tests target sources)
  set(bodies "")
  set(rows "")
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/unity_${target}_cxx.cxx)  # a name that scripts/tidy.sh knows
  foreach(source IN LISTS sources)
    get_filename_component(name ${source} NAME_WE)
    string(APPEND bodies "namespace in_${name} {\n#include \"tests/${source}\"\n}  // namespace in_${name}\n")
    string(APPEND rows "    {\"${name}\", in_${name}::main},\n")
    file(CREATE_LINK ${target} ${CMAKE_CURRENT_BINARY_DIR}/${name} SYMBOLIC)
    add_custom_target(${name} DEPENDS ${target})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})  # its includes
  endforeach()
  collect_includes(includes "${sources}")
  file(CONFIGURE OUTPUT ${unit} @ONLY CONTENT
"// Written by CMake (tests/Together.cmake).
#include <QtTest>
#include <cstdio>
#include <memory>
#include <string_view>
@includes@

@bodies@
int main(int count, char** words) {
  const struct {
    std::string_view name;
    int (*main)(int, char**);
  } programs[] = {
@rows@  };
  const std::string_view path = words[0];
  for (const auto& program : programs) {
    if (path.substr(path.rfind('/') + 1) == program.name) {
      return program.main(count, words);
    }
  }
  for (const auto& program : programs) {
    std::fprintf(stderr, \"start me as %s\\n\", program.name.data());
  }
  return 64;
}
")
  add_moc_files(mocs ${sources})
  build_test_program(${target} ${unit} "${mocs}" ${ARGN})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()
