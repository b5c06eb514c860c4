svs --enable
source agent.soar
!svs add spot world v -1.5 -0.83 -1.04 -1.5 -0.83 1.04 -1.5 0.83 -1.04 -1.5 0.83 1.04 1.5 -0.83 -1.04 1.5 -0.83 1.04 1.5 0.83 -1.04 1.5 0.83 1.04 p -2 -3.25 4.0
!svs add ball world b 0.22 r 0 1 1.5708
!svs add wheel world v -0.31 -0.99 -1.07 -0.31 -0.99 1.07 -0.31 0.99 -1.07 -0.31 0.99 1.07 0.31 -0.99 -1.07 0.31 -0.99 1.07 0.31 0.99 -1.07 0.31 0.99 1.07 p -1.0 2.0 0 r 0.07 0 -2.83
!svs add crate world v -0.49 -0.76 -0.7 -0.49 -0.76 0.7 -0.49 0.76 -0.7 -0.49 0.76 0.7 0.49 -0.76 -0.7 0.49 -0.76 0.7 0.49 0.76 -0.7 0.49 0.76 0.7 p -3.0 2 -4 r 0.5 -0.14 0
!svs add lamp world v -0.45 -1.17 -1.39 -0.45 -1.17 1.39 -0.45 1.17 -1.39 -0.45 1.17 1.39 0.45 -1.17 -1.39 0.45 -1.17 1.39 0.45 1.17 -1.39 0.45 1.17 1.39 s 0.5 0.5 0.5
!svs add tree world b 0.79 p 1.35 4 3.0 r -1.25 0 1
!svs add hero world v 0 0 0 p -3.77 0.46 -2.07
!svs tag add lamp colour blue
!svs tag add tree colour red
!svs tag add tree kind red
run 2
print -d 7 c3
!svs change hero p -4 3.0 -3 s 2 0.5 2
!svs add door world b 2 p -2 2 0
!svs change wheel p 0 1.5 3.32
!svs change spot p -1.0 -1 -4
run 1
print -d 7 c3
!svs change hero p 1.5 -3.75 -4
run 1
print -d 7 c3
!svs change tree p 2.71 -2.15 2.7
!svs change spot p 3 2.05 -3.25
!svs tag add door kind red
!svs delete ball
run 1
print -d 7 c3
!svs change door p 0.75 3.12 0.25
!svs change lamp p -1.98 3 0 r 0 1 0
!svs change crate p -2 -3.5 -3.0
run 1
print -d 7 c3
!svs? list-all-objs
