source agent.soar
trace 2
run 3
!wme w il string weather rain
run 1
!update w snow
run 2
print --gds
print --stack
