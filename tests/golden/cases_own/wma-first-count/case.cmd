source agent.soar
!wme s1 il int step 1
run 2
!destroy s1
!wme s2 il int step 2
run 1
print --internal S1
run 1
print --internal S1
