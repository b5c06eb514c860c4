source agent.soar
trace 2
!wme w il string weather rain
run 3
print --gds
!update w snow
run 2
print --depth 2 <s>
