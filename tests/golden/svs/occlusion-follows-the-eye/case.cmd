svs --enable
source agent.soar
run 1
!svs add crate world v -1 -1 -1 -1 -1 1 -1 1 -1 -1 1 1 1 -1 -1 1 -1 1 1 1 -1 1 1 1
!svs add ball world v -0.5 0 0 0.5 0 0 p 0 0 -5
!svs add spot world v 0 0 0 p 0 0 5
run 2
print -d 6 c3
!svs change spot p 20 0 -5
run 2
print -d 6 c3
!svs change crate p 10 0 -5
run 2
print -d 6 c3
!svs change ball p 0 20 -5
run 2
print -d 6 c3
