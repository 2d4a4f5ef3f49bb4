# Whole runs, some of them with thousands of trajectories per step.
set_tests_properties(run.tst_Nav2Runs PROPERTIES TIMEOUT 1800 COST 200)
set_tests_properties(run.tst_Nav2Set PROPERTIES TIMEOUT 1800 COST 150)
set_tests_properties(run.tst_ExportTrees PROPERTIES TIMEOUT 300 COST 140)  # a minute of processor time
add_test(NAME run.commit
         COMMAND ${CMAKE_COMMAND} -DSCRIPT=${PROJECT_SOURCE_DIR}/scripts/Commit.cmake
                 -DFOLDER=${output}/commit -P ${CMAKE_CURRENT_LIST_DIR}/CheckCommit.cmake)
set_tests_properties(run.commit PROPERTIES
  LABELS run TIMEOUT 60 SKIP_REGULAR_EXPRESSION "skipped: ")
