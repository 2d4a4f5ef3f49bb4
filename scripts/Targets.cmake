# Flags and the functions by which every folder becomes one target.

add_library(hunav_flags INTERFACE)
target_include_directories(hunav_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(hunav_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual
  -ffp-contract=off  # the same bits on every x86-64
  $<$<BOOL:${HUNAV_WERROR}>:-Werror>)
# Hundreds of test programs are linked: mold takes a tenth of the time of ld, gold a fifth.
find_program(HUNAV_MOLD mold)
find_program(HUNAV_GOLD ld.gold)  # of binutils, as ld is
if(HUNAV_MOLD AND HUNAV_TESTS)
  target_link_options(hunav_flags INTERFACE -fuse-ld=mold)
elseif(HUNAV_GOLD AND HUNAV_TESTS AND NOT HUNAV_SANITIZE)
  target_link_options(hunav_flags INTERFACE -fuse-ld=gold)
endif()
if(HUNAV_SANITIZE)
  target_compile_options(hunav_flags INTERFACE -fsanitize=${HUNAV_SANITIZE} -fno-sanitize-recover=all
                         -fno-omit-frame-pointer -O1 -g1  # lines of a report; a third of the disk
                         # GCC 12 takes empty optionals for uninitialised ones then
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(hunav_flags INTERFACE -fsanitize=${HUNAV_SANITIZE})
endif()

add_library(hunav_qt_flags INTERFACE)
target_compile_definitions(hunav_qt_flags INTERFACE
  QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII QT_NO_KEYWORDS QT_NO_FOREACH
  QT_DISABLE_DEPRECATED_BEFORE=0x050F00 $<$<CONFIG:RelWithDebInfo>:QT_FORCE_ASSERTS>)
target_compile_options(hunav_qt_flags INTERFACE
  # What computes lies in libraries without Qt; windows and tests compile faster so.
  $<$<CONFIG:RelWithDebInfo>:-O1>
  # Qt's QSKIP("…") has nothing for its "..."
  $<$<CXX_COMPILER_ID:Clang>:-Wno-gnu-zero-variadic-macro-arguments>)

# hunav_library(<target> [PUBLIC libs…] [PRIVATE libs…]): all .cpp of this folder and, with
# RECURSE, of its subfolders that are not folders of their own.
function(hunav_library target)
  cmake_parse_arguments(ARG "RECURSE" "" "PUBLIC;PRIVATE" ${ARGN})
  if(ARG_RECURSE)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp *.h)
  else()
    file(GLOB sources CONFIGURE_DEPENDS *.cpp *.h)
  endif()
  if(NOT sources MATCHES "\\.cpp(;|$)")  # a library of headers alone still is an archive
    set(empty ${CMAKE_CURRENT_BINARY_DIR}/${target}_empty.cpp)
    file(CONFIGURE OUTPUT ${empty} CONTENT "// ${target} has no source files.\n")
    list(APPEND sources ${empty})
  endif()
  add_library(${target} STATIC ${sources})
  set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${target} PUBLIC hunav_flags ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE})
  hunav_precompile(${target} ${ARG_PUBLIC} ${ARG_PRIVATE})
  if(HUNAV_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# Headers that nearly every file reads, parsed once for all targets without Qt, once for each other:
# with units of sixteen files a quarter of the time of a cold build. A file that forgets a standard
# header is told by layering.standard_includes; one that lives on names of its neighbours in a unit
# by a build of the preset debug, which has no units.
set(hunav_headers <algorithm> <cmath> <functional> <map> <memory> <optional> <string> <string_view>
    <utility> <vector> <Eigen/Core>)

function(hunav_precompile target)
  if(NOT HUNAV_FAST)
    return()
  endif()
  set(headers ${hunav_headers})
  if("Qt5::Widgets" IN_LIST ARGN)
    list(APPEND headers <QtWidgets>)
  endif()
  if("Qt5::Test" IN_LIST ARGN)
    list(APPEND headers <QtTest>)
  endif()
  if(headers STREQUAL hunav_headers AND NOT target STREQUAL "core_headers")
    target_precompile_headers(${target} REUSE_FROM core_headers)
  elseif(target MATCHES "^app_")  # with Qt's widgets; GCC wants the same modules of Qt
    target_precompile_headers(${target} REUSE_FROM editor)
    target_link_libraries(${target} PRIVATE Qt5::Svg)
  else()
    target_precompile_headers(${target} PRIVATE ${headers})
  endif()
  target_compile_options(${target} PRIVATE  # for ccache
    $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

if(HUNAV_FAST)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/core_headers.cpp CONTENT "// Owns a precompiled header.\n")
  add_library(core_headers OBJECT ${PROJECT_BINARY_DIR}/core_headers.cpp)
  target_link_libraries(core_headers PRIVATE hunav_flags Eigen3::Eigen)
  hunav_precompile(core_headers)
endif()

# hunav_collect(<target> <namespace> <argument type> <header of that type> <files…>): each file
# Foo.cpp defines void <namespace>::addFoo(<argument type>&); writes the function addAll<Suffix>
# that calls them all, in order of the file names. So one new file is all that a new entry needs.
function(hunav_collect target namespace function type header)
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${header})
    return()
  endif()
  set(declarations "")
  set(calls "")
  foreach(file IN LISTS ARGN)
    get_filename_component(name ${file} NAME_WE)
    string(APPEND declarations "void add${name}(${type}& to);\n")
    string(APPEND calls "  add${name}(to);\n")
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_${function}.cpp)
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Written by CMake (scripts/Targets.cmake).
#include \"${header}\"
namespace ${namespace} {
${declarations}void ${function}(${type}& to);
void ${function}([[maybe_unused]] ${type}& to) {
${calls}}
}  // namespace ${namespace}
")
  target_sources(${target} PRIVATE ${output})
endfunction()

# hunav_embed(<target> <namespace> <header> <Name>:<file>…): embeds files of resources/ into the
# program as const char* const k<Name>Text, which the header declares.
function(hunav_embed target namespace header)
  set(texts "")
  foreach(entry IN LISTS ARGN)
    string(REPLACE ":" ";" entry ${entry})
    list(GET entry 0 name)
    list(GET entry 1 file)
    set(file ${PROJECT_SOURCE_DIR}/resources/${file})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(APPEND texts "const char* const k${name}Text = R\"~~~(${text})~~~\";\n")
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_texts.cpp)
  file(CONFIGURE OUTPUT ${output} @ONLY CONTENT
"// Written by CMake (scripts/Targets.cmake).
#include \"${header}\"

namespace ${namespace} {

@texts@
}  // namespace ${namespace}
")
  target_sources(${target} PRIVATE ${output})
endfunction()

# hunav_apart(<target> <files…>): units of their own, as they use the same names, each for its own.
function(hunav_apart target)
  set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target}
                              PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
