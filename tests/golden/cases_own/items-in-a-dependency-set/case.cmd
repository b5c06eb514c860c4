source agent.soar
trace 2
!wme a il string place cave
!wme b il string place wood
!wme c il string place lake
run 3
print --gds
!destroy c
run 1
!destroy a
run 2
print --stack
