# It packs, changes and verifies a study some sixty times.
set(long 600)
if(HUNAV_SANITIZE)
  set(long 1800)
endif()
set_tests_properties(capsule.tst_Tampering PROPERTIES TIMEOUT ${long} COST 100)
