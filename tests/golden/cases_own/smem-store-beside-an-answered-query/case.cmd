source agent.soar
run 1
!wme s1 il int store 1
run 2
!wme q1 il int query 1
run 2
!destroy s1
run 3
print L1 -d 3
!destroy q1
run 2
!wme q1 il int query 1
run 2
!wme s1 il int store 1
run 2
!destroy s1
run 3
print L1 -d 3
