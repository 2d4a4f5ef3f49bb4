# The window under a real X server; skipped where there is none.
if(TARGET hunavsim)
  add_test(NAME app.workflow_xdotool
           COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/workflow_xdotool.sh $<TARGET_FILE:hunavsim>
                   ${CMAKE_CURRENT_LIST_DIR}/../data/app/workflow)
  set_tests_properties(app.workflow_xdotool PROPERTIES
    LABELS app SKIP_RETURN_CODE 77 TIMEOUT 240 ENVIRONMENT "${test_environment}")
endif()
