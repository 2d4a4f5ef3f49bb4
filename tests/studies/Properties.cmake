# Hundreds of searches with 100 000 evaluations each; whole tunings.
set_tests_properties(studies.tst_CmaEs studies.tst_Tune PROPERTIES TIMEOUT 600 COST 100)
