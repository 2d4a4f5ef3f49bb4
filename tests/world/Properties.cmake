# Steps a crowd of a thousand by a double sum over all pairs.
set_tests_properties(world.tst_CrowdForces PROPERTIES TIMEOUT 600)
# A million steps of people per map.
set_tests_properties(world.tst_WallProperty PROPERTIES TIMEOUT 600)
# Every realism test with every model.
set_tests_properties(world.tst_RealismSeedOne PROPERTIES TIMEOUT 1800)
set_property(TEST world.tst_RealismSeedOne APPEND PROPERTY ENVIRONMENT QTEST_FUNCTION_TIMEOUT=1800000)
