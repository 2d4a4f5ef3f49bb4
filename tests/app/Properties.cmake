# The window under a real X server; skipped where there is none.
if(TARGET hunavsim)
  foreach(script workflow clipboard)
    add_test(NAME app.${script}_xdotool
             COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/${script}_xdotool.sh $<TARGET_FILE:hunavsim>
                     ${CMAKE_CURRENT_LIST_DIR}/../data/app/workflow)
    set_tests_properties(app.${script}_xdotool PROPERTIES
      LABELS app SKIP_RETURN_CODE 77 TIMEOUT 240 ENVIRONMENT "${test_environment}")
  endforeach()
endif()
set(long 300)
if(HUNAV_SANITIZE)
  set(long 1800)
endif()
# tst_BrokenRuns cuts long runs short, which then write what they have.
set_tests_properties(app.tst_Extremes app.tst_BrokenRuns PROPERTIES TIMEOUT ${long} COST 100)
# It makes one study a dozen times; with HUNAV_ALL_TESTS it is killed twenty times.
set_tests_properties(app.tst_Studies app.tst_StudyTroubles PROPERTIES TIMEOUT ${long} COST 100)
# It walks through the window in each language.
set_tests_properties(app.tst_Languages PROPERTIES TIMEOUT ${long} COST 100)
# With HUNAV_ALL_TESTS it opens a window on every broken scenario.
set_tests_properties(app.tst_OneVerdict PROPERTIES TIMEOUT 1800 COST 100)
# With HUNAV_ALL_TESTS it writes and opens a map of 81 million cells.
set_tests_properties(app.tst_LargeMapMemory PROPERTIES TIMEOUT ${long})
# With HUNAV_ALL_TESTS it damages 20 000 files, which takes about 20 minutes of a processor.
set_tests_properties(app.tst_Mutations PROPERTIES TIMEOUT 10000 COST 1000)
# With HUNAV_ALL_TESTS it tries 10 000 values, which takes about two hours of a processor.
set_tests_properties(app.tst_NumericFields PROPERTIES TIMEOUT 20000 COST 1000)
# It starts the program for each step of memory.
set_tests_properties(app.tst_LowMemory PROPERTIES TIMEOUT ${long} COST 100)
# With HUNAV_ALL_TESTS it makes more than a thousand faults.
set_tests_properties(app.tst_Faults PROPERTIES TIMEOUT 3600 COST 100)
# With HUNAV_ALL_TESTS its map has 100 million cells.
set_tests_properties(app.tst_LargeMapProgram PROPERTIES TIMEOUT 1800 COST 100)
# They analyse contacts with hundreds of copies of the process each.
set_tests_properties(app.tst_ContactsProgram app.tst_ContactNotes PROPERTIES TIMEOUT ${long} COST 100)
