# What runs beside the window: under ThreadSanitizer as well (scripts/test.sh --all).
foreach(name tst_SimulationRunner tst_MetricsPanel tst_DocumentMaps tst_LatestTask)
  set_property(TEST editor.${name} APPEND PROPERTY LABELS threads)
  add_dependencies(thread_tests ${name})
endforeach()
