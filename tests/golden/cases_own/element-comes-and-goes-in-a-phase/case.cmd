source agent.soar
soar max-elaborations 6
trace 4
!wme f il int flash 1
!destroy f
run 1
!wme g il int flash 2
!wme h il int flash 3
!destroy g
run 1
