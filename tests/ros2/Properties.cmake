# Programs of others, some of which take their time to find us.
set_tests_properties(ros2.tst_Peers ros2.tst_ComeAndGo PROPERTIES TIMEOUT 300 COST 100)
