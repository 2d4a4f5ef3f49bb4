# Steps a crowd of a thousand by a double sum over all pairs.
set_tests_properties(world.tst_CrowdForces PROPERTIES TIMEOUT 600)
