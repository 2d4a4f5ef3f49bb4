# Hundreds of searches with 100 000 evaluations each; whole tunings.
set_tests_properties(studies.tst_CmaEs studies.tst_Tune PROPERTIES TIMEOUT 600 COST 100)
# Fifty contacts with hundreds of copies of the process each.
set_tests_properties(studies.tst_AvoidableContact PROPERTIES TIMEOUT 1800 COST 150)
