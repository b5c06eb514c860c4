svs --enable
source agent.soar
run 1
!svs add spot world p 2.25 3.03 1 r -1.18 1.5708 0
!svs add door world v -0.26 -1.13 -1.29 -0.26 -1.13 1.29 -0.26 1.13 -1.29 -0.26 1.13 1.29 0.26 -1.13 -1.29 0.26 -1.13 1.29 0.26 1.13 -1.29 0.26 1.13 1.29 p -1.11 -2 0.25
!svs tag add door kind red
run 2
print -d 7 c3
!svs change spot p 1.14 1.05 -1.25
!svs tag add spot kind red
run 1
print -d 7 c3
!svs? list-all-objs
