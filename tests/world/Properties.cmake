# Steps a crowd of a thousand by a double sum over all pairs.
set_tests_properties(world.tst_CrowdForces PROPERTIES TIMEOUT 600 COST 100)
# A million steps of people per map.
set_tests_properties(world.tst_WallProperty PROPERTIES TIMEOUT 1800 COST 100)
# Every realism test with seed 1.
set_tests_properties(world.tst_RealismSeedOne PROPERTIES TIMEOUT 1800 COST 100)
