# Whole runs, some of them with thousands of trajectories per step.
set_tests_properties(run.tst_Nav2Runs PROPERTIES TIMEOUT 600 COST 200)
