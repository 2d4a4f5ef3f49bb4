# Runs each scenario that comes with the program three times, some of them crowds.
set_tests_properties(bt.tst_ShippedScenarios PROPERTIES TIMEOUT 600 COST 100)
# With HUNAV_ALL_TESTS 30 000 random trees.
set_tests_properties(bt.tst_RandomTrees PROPERTIES TIMEOUT 1800)
# With HUNAV_ALL_TESTS two minutes of the café, 90 times.
set_tests_properties(bt.tst_CafeWithParkedRobot PROPERTIES TIMEOUT 1800 COST 100)
# With HUNAV_ALL_TESTS 200 seeds of each scenario of the library.
set_tests_properties(bt.tst_VariedPeople PROPERTIES TIMEOUT 1800)
